// Restart policy of the default controller.
#include "supervisor/restart_policy.hpp"

#include <algorithm>

namespace darwinop::supervisor {

std::size_t RestartPolicy::crashes(Nanos now) const {
  return static_cast<std::size_t>(
      std::count_if(at_.begin(), at_.begin() + count_, [=](Nanos at) { return now - at <= kWindow; }));
}

RestartPolicy::Verdict RestartPolicy::ended(const process::Ending& ending, Nanos now) {
  if (ending.isNormal()) return Verdict::kOver;
  if (count_ == kCrashes) {
    std::rotate(at_.begin(), at_.begin() + 1, at_.end());
    --count_;
  }
  at_[count_++] = now;
  return crashes(now) >= kCrashes ? Verdict::kGivenUp : Verdict::kAgain;
}

}  // namespace darwinop::supervisor
