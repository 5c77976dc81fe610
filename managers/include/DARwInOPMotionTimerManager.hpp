// For source compatibility only: in the framework of 2013 it started the 8 ms thread. Here Robot::step() drives the
// loop.
#ifndef DARWIN_OP_MOTION_TIMER_MANAGER_HPP
#define DARWIN_OP_MOTION_TIMER_MANAGER_HPP

namespace managers {

class DARwInOPMotionTimerManager {
 public:
  /// Does nothing, however often it is called. Thread-safe.
  static void MotionTimerInit() {}
};

}  // namespace managers

#endif
