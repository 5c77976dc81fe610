// Counts torque enables at the servos of a virtual robot.
#pragma once

#include <cstdint>

#include "hil-mocks/servo_observer.hpp"

namespace darwinop::hil {

class TorqueOnCounter final : public ServoObserver {
 public:
  [[nodiscard]] std::uint64_t count() const { return count_; }

  void written(Joint /*joint*/, std::uint8_t /*address*/, Bytes /*data*/, const ServoState& before,
               const ServoState& after) noexcept override {
    if (!before.torque_enable && after.torque_enable) ++count_;
  }
  void changed(Joint /*joint*/, ServoEvent /*event*/, const ServoState& /*before*/,
               const ServoState& /*after*/) noexcept override {}

 private:
  std::uint64_t count_ = 0;
};

}  // namespace darwinop::hil
