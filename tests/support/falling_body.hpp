// A body whose limp joints fall, and which records every torque-on edge as the servo's motor sees it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/conversions.hpp"
#include "hil-mocks/plain_body.hpp"

namespace darwinop {

class FallingBody : public hil::PlainBody {
 public:
  /// Torque came on in one servo.
  struct TorqueOn {
    Joint joint;
    double off;          // rad, goal register minus position
    double speed_limit;  // rad/s, moving speed register; infinity: none
  };

  /// From now on joints fall and edges are recorded.
  void arm() { armed_ = true; }
  [[nodiscard]] const std::vector<TorqueOn>& torqueOn() const { return edges_; }

  void step(Nanos dt, const Drives& drives) noexcept override {
    const double seconds = std::chrono::duration<double>(dt).count();
    for (std::size_t i = 0; i < kJoints; ++i) {
      const auto joint = static_cast<Joint>(i);
      const double here = state().joint[i].position_rad;
      if (armed_ && drives[i].torque_on && !was_on_[i])
        edges_.push_back({joint, drives[i].goal_rad - here, drives[i].speed_limit_rad_s});
      was_on_[i] = drives[i].torque_on;
      if (!armed_ || drives[i].torque_on) {
        fall_speed_[i] = 0;
        continue;
      }
      // A leg of a robot that stands, held by nothing but gravity. It comes to rest in the middle of its range.
      fall_speed_[i] += kFall * seconds;
      const double middle = radFromTicks((row(joint).low + row(joint).high) / 2).value;
      const double way = std::min(fall_speed_[i] * seconds, std::abs(middle - here));
      place(joint, here + std::copysign(way, middle - here));
    }
    PlainBody::step(dt, drives);
  }

 private:
  static constexpr double kFall = 12;  // rad/s2
  bool armed_ = false;
  std::array<bool, kJoints> was_on_{};
  std::array<double, kJoints> fall_speed_{};
  std::vector<TorqueOn> edges_;
};

}  // namespace darwinop
