// The motion file, 256 pages of 512 bytes: to and from bytes, without loss.
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

/// Always 256 pages.
using PageFile = std::vector<Page>;

/// Throws std::runtime_error with a sentence that names page and byte when anything is wrong with the file: a page
/// that fell on the floor is a robot that does. Page 0, which is never played, may be all zeros.
[[nodiscard]] PageFile decodePages(std::span<const std::uint8_t> bytes);

/// The checksums are made anew.
[[nodiscard]] std::vector<std::uint8_t> encodePages(const PageFile& pages);

/// As decodePages(); the sentence begins with the file's name.
[[nodiscard]] PageFile readPageFile(const std::filesystem::path& path);

/// The number of the first page with this name that can be played; 0: none.
[[nodiscard]] int findPage(const PageFile& pages, std::string_view name);

}  // namespace darwinop::motion
