// For programs started by a shell on the robot: end with that shell, even after kill -9.
#pragma once

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace darwinop {

/// Requests SIGTERM at the end of `parent`, which getppid() returned at the start. Returns false if it has already
/// ended. Call after leaveRoot(): the kernel clears the setting when a process changes its user.
inline bool endWithParent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
  return getppid() == parent;
}

}  // namespace darwinop
