// Lock between processes, by flock().
#include "runtime/file_lock.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

namespace darwinop::runtime {
namespace {

/// Opens without O_CREAT first: in a sticky folder such as /dev/shm the kernel refuses O_CREAT on a file of
/// another user, even to root (fs.protected_regular). Nothing: see errno.
std::optional<Descriptor> openLockFile(const std::string& path, gid_t group, FileOwner owner) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    if (auto file = openShared(path, O_RDWR, owner); file || errno != ENOENT) return file;
    Descriptor fresh{open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0660)};
    if (fresh.fd() >= 0) {
      // Best effort: the lock works for its owner with any permissions.
      if (fchmod(fresh.fd(), 0660) != 0 || fchown(fresh.fd(), static_cast<uid_t>(-1), group) != 0) errno = 0;
      return fresh;
    }
    if (errno != EEXIST) return std::nullopt;
  }
  return std::nullopt;
}

pid_t writtenPid(int fd) {
  char text[24] = {};
  if (pread(fd, text, sizeof text - 1, 0) <= 0) return 0;
  return static_cast<pid_t>(std::strtol(text, nullptr, 10));
}

/// Pid of the holder from /proc/locks; 0: not listed, as in a container.
pid_t listedHolder(int fd) {
  struct stat status {};
  const std::unique_ptr<FILE, int (*)(FILE*)> list{std::fopen("/proc/locks", "re"), std::fclose};
  if (!list || fstat(fd, &status) != 0) return 0;
  char line[256];
  while (std::fgets(line, sizeof line, list.get()) != nullptr) {
    // "1: FLOCK  ADVISORY  WRITE 3568 00:15:1234 0 EOF"; a waiting process has "->" in the second field.
    long pid = 0;
    unsigned device_major = 0, device_minor = 0;
    unsigned long long inode = 0;
    if (std::sscanf(line, "%*d: FLOCK ADVISORY %*s %ld %x:%x:%llu", &pid, &device_major, &device_minor, &inode) != 4)
      continue;
    if (pid > 0 && inode == status.st_ino && device_major == major(status.st_dev) &&
        device_minor == minor(status.st_dev))
      return static_cast<pid_t>(pid);
  }
  return 0;
}

/// The kernel lists who took the lock, also after its end, while another process has the file open.
pid_t ifAlive(pid_t pid) {
  return pid > 0 && (kill(pid, 0) == 0 || errno == EPERM) ? pid : 0;
}

/// Tries a shared lock; closing the file releases it.
bool isHeld(int fd) {
  return flock(fd, LOCK_SH | LOCK_NB) != 0;
}

}  // namespace

std::optional<FileLock> FileLock::tryTake(const std::string& path, gid_t group, FileOwner owner) {
  auto file = openLockFile(path, group, owner);
  if (!file)
    throw std::runtime_error("cannot open the lock file " + path + ": " + std::strerror(errno) +
                             (errno == EACCES ? "; it belongs to another user: run as that user, or have the runtime "
                                                "started with --group and a group that you are a member of. If that "
                                                "user's runtime has ended, remove what is left of it: sudo rm " +
                                                    path
                                              : ""));
  FileLock lock{std::move(*file)};
  const int fd = lock.file_.fd();
  // A call of holder() in another process may hold it briefly.
  for (int attempt = 0; flock(fd, LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EINTR && (errno != EWOULDBLOCK || attempt == 20)) return std::nullopt;
    usleep(5'000);
  }
  const std::string pid = std::to_string(getpid()) + "\n";
  if (ftruncate(fd, 0) != 0 || pwrite(fd, pid.data(), pid.size(), 0) < 0) errno = 0;  // optional
  return lock;
}

std::string pidText(pid_t holder) {
  return "pid " + (holder > 0 ? std::to_string(holder) : "unknown");
}

pid_t FileLock::holder(const std::string& path) try {
  const auto file = openShared(path, O_RDONLY, FileOwner::kAny);
  if (!file) return errno == EACCES ? -1 : 0;
  if (!isHeld(file->fd())) return 0;
  const pid_t listed = listedHolder(file->fd());
  if (const pid_t pid = ifAlive(listed > 0 ? listed : writtenPid(file->fd())); pid > 0) return pid;
  return isHeld(file->fd()) ? -1 : 0;  // -1: perhaps the pid is not written yet
} catch (const std::runtime_error&) {
  return 0;  // not a file that tryTake() would have accepted
}

pid_t FileLock::provenHolder(const std::string& path) {
  const auto file = openShared(path, O_RDONLY, FileOwner::kOwn);
  if (!file && errno == ENOENT) return 0;
  if (!file) throw std::runtime_error("cannot open " + path + ": " + std::strerror(errno) + "; ask as root: sudo ...");
  if (!isHeld(file->fd())) return 0;
  if (const pid_t listed = ifAlive(listedHolder(file->fd())); listed > 0) return listed;
  if (!isHeld(file->fd())) return 0;  // released meanwhile
  throw std::runtime_error("cannot find out which process holds " + path +
                           ": /proc/locks lists none that runs; ask on the computer itself, not in a container");
}

}  // namespace darwinop::runtime
