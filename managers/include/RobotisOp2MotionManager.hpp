// DARwInOPMotionManager under its newer name.
#ifndef ROBOTIS_OP2_MOTION_MANAGER_HPP
#define ROBOTIS_OP2_MOTION_MANAGER_HPP

#include <DARwInOPMotionManager.hpp>

namespace managers {

class RobotisOp2MotionManager : public DARwInOPMotionManager {
 public:
  explicit RobotisOp2MotionManager(webots::Robot* robot, const std::string& customMotionFile = "")
      : DARwInOPMotionManager(robot, customMotionFile) {}
};

}  // namespace managers

#endif
