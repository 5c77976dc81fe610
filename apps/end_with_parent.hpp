// For what is started by a shell on the robot: it ends when that shell does, even by kill -9.
#pragma once

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace darwinop {

/// SIGTERM comes when `parent` ends, which getppid() named at the start. False: it has ended already. Only after
/// leaveRoot(): the kernel forgets it when a process changes its user.
inline bool endWithParent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
  return getppid() == parent;
}

}  // namespace darwinop
