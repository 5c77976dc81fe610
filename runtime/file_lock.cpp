// A lock between processes that the kernel gives back when its holder dies.
#include "runtime/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace darwinop::runtime {
namespace {

/// Opens without O_CREAT first: in a sticky folder such as /dev/shm the kernel refuses O_CREAT on a file of
/// another user, even to root (fs.protected_regular).
int openLockFile(const std::string& path, gid_t group) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    int fd = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (fd >= 0 || errno != ENOENT) return fd;
    fd = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0660);
    if (fd >= 0) {
      // Best effort: with other rights the lock works all the same for its owner.
      if (fchmod(fd, 0660) != 0 || fchown(fd, static_cast<uid_t>(-1), group) != 0) errno = 0;
      return fd;
    }
    if (errno != EEXIST) return fd;
  }
  return -1;
}

pid_t writtenPid(int fd) {
  char text[24] = {};
  if (pread(fd, text, sizeof text - 1, 0) <= 0) return 0;
  return static_cast<pid_t>(std::strtol(text, nullptr, 10));
}

}  // namespace

std::optional<FileLock> FileLock::tryTake(const std::string& path, gid_t group) {
  FileLock lock{openLockFile(path, group)};
  if (lock.fd_ < 0)
    throw std::runtime_error("cannot open the lock file " + path + ": " + std::strerror(errno) +
                             (errno == EACCES ? "; it belongs to another user: run as that user, or have the runtime "
                                                "started with --group and a group that you are a member of. If that "
                                                "user's runtime has ended, remove what is left of it: sudo rm " +
                                                    path
                                              : ""));
  // Somebody who only looks may hold it for an instant (see holder()).
  for (int attempt = 0; flock(lock.fd_, LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EINTR && (errno != EWOULDBLOCK || attempt == 20)) return std::nullopt;
    usleep(5'000);
  }
  const std::string pid = std::to_string(getpid()) + "\n";
  if (ftruncate(lock.fd_, 0) != 0 || pwrite(lock.fd_, pid.data(), pid.size(), 0) < 0) errno = 0;  // only a courtesy
  return lock;
}

pid_t FileLock::holder(const std::string& path) {
  const FileLock file{open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW)};
  if (file.fd_ < 0) return errno == EACCES ? -1 : 0;
  if (flock(file.fd_, LOCK_SH | LOCK_NB) == 0) return 0;  // closing the file gives it back
  const pid_t pid = writtenPid(file.fd_);
  return pid > 0 ? pid : -1;  // -1: held, by somebody who has not written the name yet
}

FileLock::FileLock(FileLock&& other) noexcept : fd_{std::exchange(other.fd_, -1)} {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

FileLock::~FileLock() {
  if (fd_ >= 0) close(fd_);
}

}  // namespace darwinop::runtime
