// Lock between processes; the kernel releases it when its holder ends, even by a crash. Children that it has forked do
// not share it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>

#include "hal/fork_guard.hpp"
#include "runtime/shared_file.hpp"

namespace darwinop::runtime {

/// flock() on a small file that contains the holder's pid. The file remains after release; only the lock counts.
class FileLock {
 public:
  /// Takes the lock; nothing if another process has it. Throws std::runtime_error with a remedy if the file can be
  /// neither opened nor created, or its owner or permissions are not trusted. `group`: group of a new file; -1:
  /// unchanged. `owner`: whose existing file is accepted.
  static std::optional<FileLock> tryTake(const std::string& path, gid_t group = static_cast<gid_t>(-1),
                                         FileOwner owner = FileOwner::kGroup);

  FileLock(FileLock&&) noexcept = default;
  FileLock& operator=(FileLock&&) noexcept = default;
  ~FileLock() { unguardFromForks(file_.fd()); }

  /// Pid of the holder; 0: not locked; -1: unknown (the file of another user, or its holder has ended and left the lock
  /// to another process). Does not affect the holder. For messages only: where the kernel hides the pid, it is read
  /// from the file.
  static pid_t holder(const std::string& path);

  /// The same for sending signals: the file must belong to this user or root, and the pid must come from the kernel.
  /// Otherwise throws std::runtime_error with a remedy.
  static pid_t provenHolder(const std::string& path);

 private:
  explicit FileLock(Descriptor file) : file_{std::move(file)} { guardFromForks(file_.fd()); }
  Descriptor file_;
};

/// "pid 7", or "pid unknown": of a holder, for messages.
std::string pidText(pid_t holder);

}  // namespace darwinop::runtime
