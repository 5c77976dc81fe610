// Reads and writes motion files, binary or text.
#include "managers/motion_text/motion_file.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "hal/text_file.hpp"
#include "hal/write_text_file.hpp"
#include "managers/motion_text/page_text.hpp"

namespace darwinop::motion {

namespace {

// A full text has 256 pages of about 35 rows of 80 characters, 0.8 MB; the rest is for comments.
constexpr std::size_t kMaxBytes = 8U << 20U;

std::string_view textOf(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<std::uint8_t> readBytes(const std::filesystem::path& path) {
  const std::optional<std::string> bytes = readTextFile(path.string(), kMaxBytes);
  if (!bytes) throw std::runtime_error(path.string() + kCannotOpenFile);
  return {bytes->begin(), bytes->end()};
}

bool isText(const std::vector<std::uint8_t>& bytes) {
  return textOf(bytes).starts_with(kTextTitle) || std::ranges::find(bytes, std::uint8_t{0}) == bytes.end();
}

MotionFile readMotionFile(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = readBytes(path);
  if (isText(bytes)) return {parsePages(textOf(bytes), path.string()), true};
  try {
    return {decodePages(bytes), false};
  } catch (const std::runtime_error& why) {
    throw std::runtime_error(path.string() + ": " + why.what());
  }
}

void writeText(const std::filesystem::path& path, const std::string& text) {
  writeTextFile(path.string(), text);
}

void writeMotionFile(const std::filesystem::path& path, const MotionFile& file) {
  if (file.is_text) return writeText(path, writePages(file.pages));
  const std::vector<std::uint8_t> bytes = encodePages(file.pages);
  writeTextFile(path.string(), textOf(bytes));
}

}  // namespace darwinop::motion
