// DARwInOPGaitManager under its newer name.
#ifndef ROBOTIS_OP2_GAIT_MANAGER_HPP
#define ROBOTIS_OP2_GAIT_MANAGER_HPP

#include <DARwInOPGaitManager.hpp>

namespace managers {

class RobotisOp2GaitManager : public DARwInOPGaitManager {
 public:
  RobotisOp2GaitManager(webots::Robot* robot, const std::string& iniFilename)
      : DARwInOPGaitManager(robot, iniFilename) {}
};

}  // namespace managers

#endif
