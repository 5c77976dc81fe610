// Descriptors that stay with this process when it forks.
#pragma once

namespace darwinop {

/// A lock by flock() belongs to the open file, which a forked child shares: the lock, and a port, would stay taken
/// until that child ends as well. In children forked from now on `fd` refers to /dev/null instead, and their objects
/// may still close it. Programs that a child executes are the business of O_CLOEXEC. Descriptors of 1024 and more are
/// shared. Thread-safe and lock-free.
void guardFromForks(int fd) noexcept;
/// To be called before `fd` is closed. One that is not guarded is ignored.
void unguardFromForks(int fd) noexcept;

}  // namespace darwinop
