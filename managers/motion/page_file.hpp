// Motion file: 256 pages of 512 bytes, lossless conversion.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "managers/motion/page.hpp"

namespace darwinop::motion {

inline constexpr std::size_t kPageBytes = 512;
inline constexpr std::size_t kFileBytes = kPages * kPageBytes;

/// After the path.
inline constexpr const char* kCannotOpenFile = ": cannot open the file";

/// Always 256 pages.
using PageFile = std::vector<Page>;

/// Throws std::runtime_error with page and byte for any error: a damaged page could make the robot fall. Page 0, which
/// is never played, may be all zeros.
[[nodiscard]] PageFile decodePages(std::span<const std::uint8_t> bytes);

/// Computes the checksums.
[[nodiscard]] std::vector<std::uint8_t> encodePages(const PageFile& pages);

/// As decodePages(); messages begin with the path.
[[nodiscard]] PageFile readPageFile(const std::filesystem::path& path);

/// Number of the first playable page with this name; 0: none.
[[nodiscard]] int findPage(const PageFile& pages, std::string_view name);

}  // namespace darwinop::motion
