#include "hal/text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "hal/descriptor.hpp"

namespace darwinop {
namespace {

constexpr const char* kRemedy = "; make it readable for this user (chmod a+r)";

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::runtime_error("cannot read " + path + ": " + why);
}

/// "No file", as programs say it.
bool isNull(const struct stat& about) {
  return S_ISCHR(about.st_mode) && about.st_rdev == makedev(1, 3);
}

const char* kindOf(mode_t mode) {
  return S_ISDIR(mode) ? kFolderInsteadOfFile : S_ISFIFO(mode) ? kPipeInsteadOfFile : kDeviceInsteadOfFile;
}

}  // namespace

std::optional<std::string> readTextFile(const std::string& path, std::size_t longest) {
  // Without O_NONBLOCK the opening of a pipe waits for its writer.
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  if (file.fd() < 0 && errno == ENOENT) return std::nullopt;
  struct stat about {};
  if (file.fd() < 0 || fstat(file.fd(), &about) != 0)
    refuse(path, std::strerror(errno) + std::string{errno == EACCES ? kRemedy : ""});
  if (isNull(about)) return std::string{};
  if (!S_ISREG(about.st_mode)) refuse(path, kindOf(about.st_mode) + std::string{"; give a regular file"});
  const auto check = [&](std::size_t size) {
    if (size > longest) refuse(path, "it is longer than " + std::to_string(longest) + " bytes; is it the right file?");
  };
  check(static_cast<std::size_t>(about.st_size));
  std::string text;
  text.reserve(static_cast<std::size_t>(about.st_size));
  std::array<char, 4096> part{};
  for (;;) {
    const ssize_t size = ::read(file.fd(), part.data(), part.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) refuse(path, std::strerror(errno));
    if (size == 0) return text;
    text.append(part.data(), static_cast<std::size_t>(size));
    check(text.size());  // files of /proc report a size of 0
  }
}

}  // namespace darwinop
