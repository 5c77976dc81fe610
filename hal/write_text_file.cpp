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
  if (!file) throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
}

/// A regular file of ours, or none, in a folder in which we may make another.
bool isReplaceable(const std::string& file) {
  const std::string folder = std::filesystem::absolute(file).parent_path();
  if (access(folder.c_str(), W_OK) != 0) return false;
  struct stat old {};
  return stat(file.c_str(), &old) != 0 || (S_ISREG(old.st_mode) && old.st_uid == geteuid());
}

}  // namespace

void writeTextFile(const std::string& path, std::string_view text) {
  const std::string file = linkedFile(path);
  if (!isReplaceable(file)) return writeThrough(path, text);
  const std::string fresh = writeBeside(file, text);
  if (std::rename(fresh.c_str(), file.c_str()) == 0) return flushFolder(file);
  const std::string why = std::strerror(errno);
  unlink(fresh.c_str());
  throw std::runtime_error("cannot write " + path + ": " + why);
}

}  // namespace darwinop
