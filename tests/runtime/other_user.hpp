// What another user of the computer can do.
#pragma once

#include <grp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

namespace darwinop::runtime {

/// Runs `body` as user 65534 in a process of its own, to its end. False: only root can become another user.
inline bool asNobody(const std::function<void()>& body) {
  if (geteuid() != 0) return false;
  const pid_t child = fork();
  if (child == 0) {
    if (setgroups(0, nullptr) != 0 || setgid(65534) != 0 || setuid(65534) != 0) _exit(2);
    body();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace darwinop::runtime
