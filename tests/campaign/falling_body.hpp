// A body whose limp joints fall, so that a goal of a moment ago is not where the joint is.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/conversions.hpp"
#include "hil-mocks/plain_body.hpp"

namespace darwinop {

/// Every joint but the head's falls towards the sitting pose, as the legs of a robot that stands collapse.
class FallingBody final : public hil::PlainBody {
 public:
  void step(Nanos dt, const Drives& drives) noexcept override {
    PlainBody::step(dt, drives);
    const double dt_s = std::chrono::duration<double>(dt).count();
    for (std::size_t i = 0; i < kJoints; ++i) {
      if (drives[i].torque_on || kJointTable[i].chain == Chain::kHead) continue;
      fall(motion(static_cast<Joint>(i)), radFromTicks(kJointTable[i].start).value, dt_s);
    }
  }

 private:
  static constexpr double kAcceleration = 12;  // rad/s2: a shank of 0.1 m under the robot's weight, roughly

  static void fall(JointMotion& joint, double rest, double dt_s) noexcept {
    const double way = rest - joint.position_rad;
    joint.velocity_rad_s += std::copysign(kAcceleration * dt_s, way);
    if (std::abs(way) > std::abs(joint.velocity_rad_s) * dt_s || way * joint.velocity_rad_s < 0) return;
    joint.position_rad = rest;
    joint.velocity_rad_s = 0;
  }
};

}  // namespace darwinop
