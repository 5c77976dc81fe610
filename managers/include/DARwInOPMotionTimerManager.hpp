// Started the 8 ms thread of the old framework. Nothing to start here: the loop runs by itself, and pages are played by
// playPage() or step() of the motion manager. Controllers may call it, once or often; it does nothing and says nothing.
#ifndef DARWIN_OP_MOTION_TIMER_MANAGER_HPP
#define DARWIN_OP_MOTION_TIMER_MANAGER_HPP

namespace managers {

class DARwInOPMotionTimerManager {
 public:
  static void MotionTimerInit() {}
};

}  // namespace managers

#endif
