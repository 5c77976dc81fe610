// A process of root without root's rights, for a scope.
#pragma once

#include <unistd.h>

namespace darwinop {

/// Nothing changes for another user.
class AsNobody {
 public:
  static constexpr uid_t kNobody = 65534;
  AsNobody() : root_{geteuid() == 0} {
    if (root_) root_ = setresuid(kNobody, kNobody, 0) == 0;
  }
  ~AsNobody() {
    if (root_ && setresuid(0, 0, 0) != 0) _exit(1);
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool root_;
};

}  // namespace darwinop
