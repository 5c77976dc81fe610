#include "hal/replace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "hal/descriptor.hpp"

namespace darwinop {
namespace {

/// 0, or errno.
int writeWhole(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t size = write(file, text.data(), text.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(size));
  }
  return fsync(file) == 0 ? 0 : errno;
}

int takeModeAndOwner(int file, const std::string& path) {
  struct stat old {};
  const bool exists = stat(path.c_str(), &old) == 0;
  const mode_t hidden = umask(0);  // can only be read by setting it
  umask(hidden);
  if (fchmod(file, exists ? old.st_mode & 07777 : 0666 & ~hidden) != 0) return errno;
  if (!exists || (old.st_uid == geteuid() && old.st_gid == getegid())) return 0;
  return fchown(file, old.st_uid, old.st_gid) == 0 ? 0 : errno;
}

}  // namespace

std::string writeBeside(const std::string& path, std::string_view text) {
  std::string fresh = path + ".XXXXXX";
  const Descriptor file{mkostemp(fresh.data(), O_CLOEXEC)};
  int why = file.fd() < 0 ? errno : takeModeAndOwner(file.fd(), path);
  if (why == 0) why = writeWhole(file.fd(), text);
  if (why == 0) return fresh;
  if (file.fd() >= 0) unlink(fresh.c_str());
  throw std::runtime_error(kCannotWrite + path + ": " + std::strerror(why));
}

void flushFolder(const std::string& path) {
  const std::string folder = std::filesystem::absolute(path).parent_path();
  const Descriptor file{open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (file.fd() >= 0) fsync(file.fd());
}

std::string linkedFile(const std::string& path) {
  std::error_code missing;
  const std::filesystem::path real = std::filesystem::canonical(path, missing);
  return missing ? path : real.string();
}

}  // namespace darwinop
