// Opening and linking a pseudo terminal.
#include "hil-mocks/pty.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace darwinop::hil {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

bool isOrMayBeLink(const std::string& path) {
  struct stat info;
  return lstat(path.c_str(), &info) != 0 || S_ISLNK(info.st_mode);
}

}  // namespace

Pty::Pty(std::string link) : link_{std::move(link)} {
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0) fail("cannot create a pseudo terminal; check that /dev/pts is mounted");
  char name[64];
  if (grantpt(master_) != 0 || unlockpt(master_) != 0 || ptsname_r(master_, name, sizeof name) != 0) {
    close(master_);
    fail("cannot unlock the pseudo terminal");
  }
  path_ = name;
  slave_ = open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios raw{};
  if (slave_ < 0 || tcgetattr(slave_, &raw) != 0) {
    close(master_);
    fail("cannot open " + path_);
  }
  cfmakeraw(&raw);
  cfsetspeed(&raw, B1000000);
  tcsetattr(slave_, TCSANOW, &raw);
  try {
    makeLink();
  } catch (...) {
    close(slave_);
    close(master_);
    throw;
  }
}

Pty::~Pty() {
  char target[256];
  const ssize_t size = link_.empty() ? -1 : readlink(link_.c_str(), target, sizeof target);
  if (size > 0 && path_ == std::string(target, static_cast<std::size_t>(size))) unlink(link_.c_str());
  close(slave_);
  close(master_);
}

void Pty::makeLink() const {
  if (link_.empty()) return;
  if (!isOrMayBeLink(link_))
    throw std::runtime_error(link_ + " exists and is not a symbolic link; choose another path for --link");
  // Created aside and renamed, so that the path always exists and is complete.
  const std::string aside = link_ + ".new";
  unlink(aside.c_str());
  if (symlink(path_.c_str(), aside.c_str()) != 0 || std::rename(aside.c_str(), link_.c_str()) != 0) {
    const int error = errno;
    unlink(aside.c_str());
    errno = error;
    fail("cannot create the symbolic link " + link_);
  }
}

std::size_t Pty::read(std::span<std::uint8_t> into) noexcept {
  const ssize_t count = ::read(master_, into.data(), into.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::size_t Pty::write(Bytes bytes) noexcept {
  const ssize_t count = ::write(master_, bytes.data(), bytes.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void Pty::dropStaleClaim() noexcept {
  ioctl(slave_, TIOCNXCL);
}

}  // namespace darwinop::hil
