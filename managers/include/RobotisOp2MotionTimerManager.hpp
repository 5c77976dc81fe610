// DARwInOPMotionTimerManager under its newer name.
#ifndef ROBOTIS_OP2_MOTION_TIMER_MANAGER_HPP
#define ROBOTIS_OP2_MOTION_TIMER_MANAGER_HPP

#include <DARwInOPMotionTimerManager.hpp>

namespace managers {

/// All methods are those of DARwInOPMotionTimerManager.
class RobotisOp2MotionTimerManager : public DARwInOPMotionTimerManager {};

}  // namespace managers

#endif
