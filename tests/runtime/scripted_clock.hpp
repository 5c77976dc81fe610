// A clock that stands still unless somebody sleeps on it or spends time.
#pragma once

#include "runtime/clock.hpp"

namespace darwinop::runtime {

class ScriptedClock final : public Clock {
 public:
  [[nodiscard]] Nanos now() const noexcept override { return now_; }
  void sleepUntil(Nanos time) noexcept override {
    now_ = (time > now_ ? time : now_) + oversleep_;
    oversleep_ = Nanos{0};
  }
  void spend(Nanos time) { now_ += time; }
  /// The next sleep ends this late.
  void oversleep(Nanos time) { oversleep_ = time; }

 private:
  Nanos now_{1'000'000'000};
  Nanos oversleep_{0};
};

}  // namespace darwinop::runtime
