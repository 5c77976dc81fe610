// Motion files, binary or text; the type is detected from the content, not from the name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// After the path.
inline constexpr const char* kCannotOpenFile = ": cannot open the file";

/// Throws std::runtime_error if the file cannot be read or is longer than any motion file.
[[nodiscard]] std::vector<std::uint8_t> readBytes(const std::filesystem::path& path);
/// True if there is no zero byte or the first line is the text title; the vendor's binary files contain many zeros.
[[nodiscard]] bool isText(const std::vector<std::uint8_t>& bytes);

struct MotionFile {
  PageFile pages;
  bool is_text = false;
};

/// Throws std::runtime_error with file, and page and byte or line and field.
[[nodiscard]] MotionFile readMotionFile(const std::filesystem::path& path);

/// Atomic: replaces an existing file only when the new one is complete. Throws std::runtime_error.
void writeMotionFile(const std::filesystem::path& path, const MotionFile& file);
void writeText(const std::filesystem::path& path, const std::string& text);

}  // namespace darwinop::motion
