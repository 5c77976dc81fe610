// A motion file on the disk, binary or text.
#include "managers/motion_text/motion_file.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "hal/text_file.hpp"
#include "managers/motion_text/page_text.hpp"

namespace darwinop::motion {

namespace {

// A full text has 256 pages of some 35 rows of 80 letters, 0.8 MB; this leaves room for remarks.
constexpr std::size_t kMostBytes = 8U << 20U;

std::string_view textOf(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void writeWhole(const std::filesystem::path& path, const char* data, std::size_t size) {
  const std::filesystem::path part = path.string() + ".part";
  std::ofstream file{part, std::ios::binary | std::ios::trunc};
  file.write(data, static_cast<std::streamsize>(size));
  file.close();
  std::error_code failed;
  if (file) std::filesystem::rename(part, path, failed);
  if (file && !failed) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw std::runtime_error(path.string() + ": it cannot be written; is there such a folder, and may you write to it?");
}

}  // namespace

std::vector<std::uint8_t> readBytes(const std::filesystem::path& path) {
  const std::optional<std::string> bytes = readTextFile(path.string(), kMostBytes);
  if (!bytes) throw std::runtime_error(path.string() + ": it cannot be opened");
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
  writeWhole(path, text.data(), text.size());
}

void writeMotionFile(const std::filesystem::path& path, const MotionFile& file) {
  if (file.is_text) return writeText(path, writePages(file.pages));
  const std::vector<std::uint8_t> bytes = encodePages(file.pages);
  writeWhole(path, reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace darwinop::motion
