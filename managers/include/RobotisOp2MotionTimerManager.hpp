// DARwInOPMotionTimerManager under its newer name.
#ifndef ROBOTIS_OP2_MOTION_TIMER_MANAGER_HPP
#define ROBOTIS_OP2_MOTION_TIMER_MANAGER_HPP

#include <DARwInOPMotionTimerManager.hpp>

namespace managers {

class RobotisOp2MotionTimerManager : public DARwInOPMotionTimerManager {};

}  // namespace managers

#endif
