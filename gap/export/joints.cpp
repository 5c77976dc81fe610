#include "gap/export/joints.hpp"

#include <stdexcept>

namespace darwinop::gap {

std::unique_ptr<TargetJoint> jointOf(Target target, const ServoNumbers& servo, const ArmNumbers& arm, double step_s) {
  switch (target) {
    case Target::kWebots:
      return webotsJoint(servo, arm, step_s);
    case Target::kMujoco:
      return mujocoJoint(servo, arm, step_s);
    case Target::kUrdf:
      return urdfJoint(servo, arm, step_s);
  }
  throw std::logic_error("no such target");
}

}  // namespace darwinop::gap
