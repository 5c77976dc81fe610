// Motion file: 256 pages of 512 bytes, lossless conversion.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "managers/motion/page.hpp"

namespace darwinop::motion {

inline constexpr std::size_t kPageBytes = 512;
inline constexpr std::size_t kFileBytes = kPages * kPageBytes;

/// Always 256 pages.
using PageFile = std::vector<Page>;

/// Throws std::runtime_error with page and byte for any error: a damaged page could make the robot fall. Page 0, which
/// is never played, may be all zeros.
[[nodiscard]] PageFile decodePages(std::span<const std::uint8_t> bytes);

/// Computes the checksums.
[[nodiscard]] std::vector<std::uint8_t> encodePages(const PageFile& pages);

}  // namespace darwinop::motion
