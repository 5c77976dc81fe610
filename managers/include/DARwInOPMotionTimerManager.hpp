// Started the 8 ms thread of the old framework. Nothing to start here: the loop runs by itself.
#ifndef DARWIN_OP_MOTION_TIMER_MANAGER_HPP
#define DARWIN_OP_MOTION_TIMER_MANAGER_HPP

namespace managers {

class DARwInOPMotionTimerManager {
 public:
  static void MotionTimerInit() {}
};

}  // namespace managers

#endif
