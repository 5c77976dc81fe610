// So much a second and no more, whoever sends what: it bounds the server's share of a robot's CPU.
#pragma once

#include <algorithm>

#include "hal/byte_line.hpp"

namespace darwinop::net {

class Allowance {
 public:
  /// One piece of work every `each` on average, `at_once` of them after a pause. 0: without limit.
  Allowance(Nanos each, int at_once) : each_{each}, ahead_{each * at_once} {}

  [[nodiscard]] bool left(Nanos now) const { return wait(now) <= Nanos{0}; }
  /// Until something is left; 0 or less when something is.
  [[nodiscard]] Nanos wait(Nanos now) const {
    return each_ == Nanos{0} ? Nanos{0} : paid_until_ + each_ - now - ahead_;
  }
  /// Work is done even when nothing is left; it is paid for later.
  void spend(Nanos now) { paid_until_ = std::max(paid_until_, now) + each_; }

 private:
  Nanos each_, ahead_;
  Nanos paid_until_{0};
};

}  // namespace darwinop::net
