// DARwInOPMotionManager under its newer name; its motion file is in the data directory of the ROBOTIS OP2.
#ifndef ROBOTIS_OP2_MOTION_MANAGER_HPP
#define ROBOTIS_OP2_MOTION_MANAGER_HPP

#include <DARwInOPMotionManager.hpp>
#include <RobotisOp2DirectoryManager.hpp>

namespace managers {

/// All methods are those of DARwInOPMotionManager.
class RobotisOp2MotionManager : public DARwInOPMotionManager {
 public:
  /// Same as DARwInOPMotionManager(), but "" names motion_4096.bin in /robotis/Data/.
  explicit RobotisOp2MotionManager(webots::Robot* robot, const std::string& customMotionFile = "")
      : DARwInOPMotionManager(robot, customMotionFile, RobotisOp2DirectoryManager::getDataDirectory()) {}
};

}  // namespace managers

#endif
