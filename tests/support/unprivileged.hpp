// A process of root without root's rights, for a scope.
#pragma once

#include <unistd.h>

namespace darwinop {

/// Nothing changes for another user.
class Unprivileged {
 public:
  static constexpr uid_t kUser = 65534;
  Unprivileged() : root_{geteuid() == 0} {
    if (root_) root_ = setresuid(kUser, kUser, 0) == 0;
  }
  ~Unprivileged() {
    if (root_ && setresuid(0, 0, 0) != 0) _exit(1);
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;

 private:
  bool root_;
};

}  // namespace darwinop
