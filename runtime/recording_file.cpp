#include "runtime/recording_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

/// True if the bytes at `offset` from `origin` are `text`.
bool has(const std::string& path, std::ios::seekdir origin, std::streamoff offset, const std::string& text) {
  std::string found(text.size(), '\0');
  std::ifstream file{path, std::ios::binary};
  file.seekg(offset, origin);
  return file.read(found.data(), static_cast<std::streamsize>(found.size())) && found == text;
}

/// Longer than the two last lines.
std::string lastBytes(const std::string& path) {
  constexpr std::streamoff kMost = 200;
  std::ifstream file{path, std::ios::binary | std::ios::ate};
  const std::streamoff size = std::max<std::streamoff>(file.tellg(), 0);
  std::string end(static_cast<std::size_t>(std::min(size, kMost)), '\0');
  file.seekg(size - static_cast<std::streamoff>(end.size()));
  return file.read(end.data(), static_cast<std::streamsize>(end.size())) ? end : "";
}

bool isRegularFile(const std::string& path) {
  std::error_code absent;
  return std::filesystem::is_regular_file(path, absent);
}

}  // namespace

void requireNewRecording(const std::string& path) {
  if (isRegularFile(path)) throw std::runtime_error(path + messages::kRecordingExists);
}

void requireReplaceableRecording(const std::string& path) {
  std::error_code unknown;
  if (!isRegularFile(path) || std::filesystem::file_size(path, unknown) == 0) return;
  if (!has(path, std::ios::beg, 0, kRecordingHead)) throw std::runtime_error(path + messages::kNotARecording);
}

bool isCompleteRecording(const std::string& path) {
  std::error_code absent;
  if (!isRegularFile(path)) return std::filesystem::exists(path, absent);
  const std::string end = lastBytes(path);
  return end.ends_with(kEndOfRecording) && end.find(kLostRows) == end.npos;
}

}  // namespace darwinop::runtime
