// Load of one joint with all other joints fixed: exactly a pendulum, for any axis direction.
#pragma once

#include <array>

#include "core/joints.hpp"
#include "twin/model/model.hpp"

namespace darwinop::twin {
namespace messages {
inline constexpr const char* kAngleUnknown = " never answers, and the load of ";
}  // namespace messages

/// inertia q'' = torque - weight sin(q - hangs_at)
struct JointPendulum {
  double weight_nm;     // maximum gravity torque; 0 for a vertical axis
  double hangs_at_rad;  // stable equilibrium angle of the joint
  double inertia_kgm2;  // without the servo's rotor
};

/// `angles_rad`: of all joints; the angle of `joint` is ignored, and NaN stands for one that is not known.
/// `accel_m_s2`: an ideal accelerometer at rest (right, forward, up), which gives the direction of gravity. The trunk
/// is fixed; effects of the model are not applied. Throws std::runtime_error if MuJoCo cannot load the body, or if an
/// angle of the same limb is not known.
JointPendulum pendulumOf(const Model& model, Joint joint, const std::array<double, kJoints>& angles_rad,
                         const std::array<double, 3>& accel_m_s2);

}  // namespace darwinop::twin
