#include "hal/write_text_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "hal/replace_file.hpp"

namespace darwinop {
namespace {

void writeThrough(const std::string& path, std::string_view text) {
  errno = 0;
  std::ofstream file{path, std::ios::binary};
  file << text;
  file.close();
  if (!file) throw std::runtime_error(kCannotWrite + path + ": " + std::strerror(errno));
}

/// /dev/stdout and the like: what it leads to is open, and more may be written to it.
bool isOpenElsewhere(const std::string& path) {
  const std::string place = std::filesystem::absolute(path).lexically_normal();
  return place.starts_with("/dev/") || place.starts_with("/proc/");
}

/// A regular file of ours that we may write, or none, in a folder in which we may make another.
bool isReplaceable(const std::string& file) {
  const std::string folder = std::filesystem::absolute(file).parent_path();
  if (access(folder.c_str(), W_OK) != 0) return false;
  struct stat old {};
  if (stat(file.c_str(), &old) != 0) return true;
  return S_ISREG(old.st_mode) && old.st_uid == geteuid() && access(file.c_str(), W_OK) == 0;
}

}  // namespace

void writeTextFile(const std::string& path, std::string_view text) {
  const std::string file = linkedFile(path);
  if (isOpenElsewhere(path) || !isReplaceable(file)) return writeThrough(path, text);
  const std::string fresh = writeBeside(file, text);
  if (std::rename(fresh.c_str(), file.c_str()) == 0) return flushFolder(file);
  unlink(fresh.c_str());
  writeThrough(path, text);  // a mount point, for example
}

}  // namespace darwinop
