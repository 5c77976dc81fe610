// A lock between processes that the kernel gives back when its holder dies, however it dies.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace darwinop::runtime {

/// flock() on a small file that also says who holds it. The file stays behind; only the lock counts.
class FileLock {
 public:
  /// Takes the lock, or gives nothing when another process has it. Throws std::runtime_error, with what to do,
  /// when the file can be neither opened nor made. `group`: who else may use the file, -1: unchanged.
  static std::optional<FileLock> tryTake(const std::string& path, gid_t group = static_cast<gid_t>(-1));

  /// Pid of the holder, 0: nobody holds it, -1: not to be told (the file is another user's). Never disturbs the holder.
  static pid_t holder(const std::string& path);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

 private:
  explicit FileLock(int fd) : fd_{fd} {}
  int fd_ = -1;
};

}  // namespace darwinop::runtime
