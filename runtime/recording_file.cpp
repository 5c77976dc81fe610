#include "runtime/recording_file.hpp"

#include <cstring>
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
  return has(path, std::ios::end, -static_cast<std::streamoff>(std::strlen(kEndOfRecording)), kEndOfRecording);
}

}  // namespace darwinop::runtime
