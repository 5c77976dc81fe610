// Torque scale of each joint's servo: 1023 counts of its load and torque limit are its stall torque.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/conversions.hpp"
#include "core/joints.hpp"

namespace darwinop::cm730 {

/// All MX-28 at first. Loads are fractions of an MX-28's stall torque, whatever the servo, so that a load or a limit
/// means the same torque at every joint.
class StallTorques {
 public:
  constexpr StallTorques() { ratio_.fill(1); }
  void set(Joint joint, NewtonMeter stall) noexcept { ratio_[index(joint)] = stall.value / kMaxTorqueNm; }

  /// Register 34 for a torque limit. Never 0 for a stronger servo, as that is what a servo shows that has shut itself
  /// off.
  [[nodiscard]] std::uint16_t limitRegister(Joint joint, NewtonMeter limit) const noexcept {
    const double ratio = ratio_[index(joint)];
    const std::uint16_t counts = registerFromTorque(NewtonMeter{limit.value / ratio});
    return ratio > 1 && limit.value > 0 ? std::max<std::uint16_t>(counts, 1) : counts;
  }
  [[nodiscard]] NewtonMeter limit(Joint joint, std::uint16_t raw) const noexcept {
    return NewtonMeter{torqueFromRegister(raw).value * ratio_[index(joint)]};
  }
  [[nodiscard]] double load(Joint joint, std::uint16_t raw) const noexcept {
    return loadFromRegister(raw) * ratio_[index(joint)];
  }

 private:
  std::array<double, kJoints> ratio_{};  // to the MX-28's stall torque
};

}  // namespace darwinop::cm730
