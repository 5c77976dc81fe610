// What one joint of the body swings when all others stand still: exactly a pendulum, wherever its axis points.
#pragma once

#include <array>

#include "core/joints.hpp"
#include "twin/model/model.hpp"

namespace darwinop::twin {

/// inertia q'' = torque - weight sin(q - hangs_at)
struct JointPendulum {
  double weight_nm;     // of gravity, when the link stands out sideways; 0 for an upright axis
  double hangs_at_rad;  // angle of the joint at which the link hangs
  double inertia_kgm2;  // without the servo's rotor
};

/// `angles_rad`: of all joints; that of `joint` itself does not matter. `accel_m_s2`: what the accelerometer tells at
/// rest, right, forward, up: where down is. The trunk is held, and effects of the model change nothing here. Throws
/// std::runtime_error for a body that MuJoCo refuses.
JointPendulum pendulumOf(const Model& model, Joint joint, const std::array<double, kJoints>& angles_rad,
                         const std::array<double, 3>& accel_m_s2);

}  // namespace darwinop::twin
