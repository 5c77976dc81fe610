// A motion file on the disk, binary or text: which of the two is told by what is in it, not by its name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// Throws std::runtime_error when the file cannot be read, or is longer than any motion file.
[[nodiscard]] std::vector<std::uint8_t> readBytes(const std::filesystem::path& path);
/// True for what has no zero byte, and for what begins as our text does: a motion file of the vendor's is full of
/// zeros.
[[nodiscard]] bool isText(const std::vector<std::uint8_t>& bytes);

struct MotionFile {
  PageFile pages;
  bool is_text = false;
};

/// Throws std::runtime_error with a sentence that names the file, and page and byte, or line and field.
[[nodiscard]] MotionFile readMotionFile(const std::filesystem::path& path);

/// All of it or nothing: what was there before stays until the new file is whole. Throws std::runtime_error.
void writeMotionFile(const std::filesystem::path& path, const MotionFile& file);
void writeText(const std::filesystem::path& path, const std::string& text);

}  // namespace darwinop::motion
