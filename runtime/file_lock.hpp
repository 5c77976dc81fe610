// A lock between processes that the kernel gives back when its holder dies, however it dies.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>

#include "runtime/shared_file.hpp"

namespace darwinop::runtime {

/// flock() on a small file that also says who holds it. The file stays behind; only the lock counts.
class FileLock {
 public:
  /// Takes the lock, or gives nothing when another process has it. Throws std::runtime_error, with what to do,
  /// when the file can be neither opened nor made, or must not be used. `group`: who else may use the file, -1:
  /// unchanged. `owner`: whose file of that name is accepted.
  static std::optional<FileLock> tryTake(const std::string& path, gid_t group = static_cast<gid_t>(-1),
                                         FileOwner owner = FileOwner::kGroup);

  /// Pid of the holder, 0: nobody holds it, -1: unknown (the file is another user's). Never disturbs the holder.
  /// For messages: where the kernel hides the pid, it is the one written in a trusted user's file.
  static pid_t holder(const std::string& path);

  /// The same for sending signals: the file belongs to this user or to root, and the pid comes from the kernel. Throws
  /// std::runtime_error, with what to do, when either cannot be had.
  static pid_t provenHolder(const std::string& path);

 private:
  explicit FileLock(SharedFile file) : file_{std::move(file)} {}
  SharedFile file_;
};

}  // namespace darwinop::runtime
