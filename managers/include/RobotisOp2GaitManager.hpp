// DARwInOPGaitManager under its newer name.
#ifndef ROBOTIS_OP2_GAIT_MANAGER_HPP
#define ROBOTIS_OP2_GAIT_MANAGER_HPP

#include <DARwInOPGaitManager.hpp>

namespace managers {

/// All methods are those of DARwInOPGaitManager; the two robots have the same legs.
class RobotisOp2GaitManager : public DARwInOPGaitManager {
 public:
  /// Same as DARwInOPGaitManager().
  RobotisOp2GaitManager(webots::Robot* robot, const std::string& iniFilename)
      : DARwInOPGaitManager(robot, iniFilename) {}
};

}  // namespace managers

#endif
