// The motors of a walk: with limits lifted and gains of its own while it has them, as they were before behind that.
#pragma once

#include <array>
#include <cstdint>

#include "managers/gait/approach.hpp"
#include "managers/gait/goals.hpp"
#include "managers/gait/parameters.hpp"

namespace webots {
class Motor;
class Robot;
}  // namespace webots
namespace darwinop::facade {
class RobotImpl;
}

namespace managers {

/// Gives them back at its end. A copy has borrowed nothing.
class BorrowedMotors {
 public:
  BorrowedMotors() = default;  // of no robot
  /// Throws std::runtime_error when a joint is missing.
  explicit BorrowedMotors(webots::Robot& robot);
  BorrowedMotors(const BorrowedMotors& other) : inside_{other.inside_}, motors_{other.motors_} {}
  BorrowedMotors& operator=(const BorrowedMotors& other);
  ~BorrowedMotors() { giveBack(); }

  /// False: there is no robot, or it has gone and its motors with it.
  [[nodiscard]] bool exist() const;
  /// By whom they are moved now; nobody: the controller itself.
  [[nodiscard]] bool areOurs() const { return takenBy() == this; }
  [[nodiscard]] bool areAnothers() const { return takenBy() != this && takenBy() != nullptr; }

  /// Walking needs what the servos can give: a speed limit of the controller's would make it fall.
  void take(const darwinop::gait::Parameters& gains);
  void giveBack();

  /// Cycle of the loop in which the board, whose gyroscope a walk looks at, was read last.
  [[nodiscard]] std::uint64_t cycleOfReading() const;
  /// rad, where a walk may begin without a jump: core/present_goal.hpp.
  [[nodiscard]] darwinop::gait::Pose present() const;
  void setGoals(const darwinop::gait::Pose& goals);

 private:
  [[nodiscard]] const void* takenBy() const;

  darwinop::facade::RobotImpl* inside_ = nullptr;
  std::array<webots::Motor*, darwinop::gait::kWalkingJoints> motors_{};
  bool lifted_ = false;
  std::array<double, darwinop::gait::kWalkingJoints> speed_{}, acceleration_{};  // before they were lifted
};

}  // namespace managers
