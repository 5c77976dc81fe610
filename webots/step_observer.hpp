// Follows the steps of the robot: a manager that moves joints without a call of the controller, as on the robot of
// 2013, where it had a thread of its own.
#pragma once

namespace darwinop::webots_api {

/// On the list of observers during its lifetime. Used by the thread of the robot only.
class StepObserver {
 public:
  StepObserver();
  virtual ~StepObserver();
  StepObserver(const StepObserver&) = delete;
  StepObserver& operator=(const StepObserver&) = delete;

  /// At the start of each Robot::step(), `ms` as passed to it, before the motors' commands are computed.
  virtual void beforeStep(int ms) = 0;
  /// Once, before the session ends, unless the loop or safety has ended it: moves the joints where the robot can kneel,
  /// by RobotImpl::carryOn().
  virtual void beforeEnd() = 0;
};

void notifyBeforeStep(int ms);
void notifyBeforeEnd();

}  // namespace darwinop::webots_api
