// Motors during a walk: full speed and the walk's P gains override what the controller has set or sets meanwhile.
#pragma once

#include <array>
#include <cstdint>

#include "managers/body_player/walk_player.hpp"

namespace webots {
class Motor;
class Robot;
}  // namespace webots
namespace darwinop::webots_api {
class RobotImpl;
}

namespace managers {

/// The destructor ends the overrides. A copy has not taken the motors.
class BorrowedMotors {
 public:
  BorrowedMotors() = default;  // without a robot
  /// Throws std::runtime_error if a joint is missing.
  explicit BorrowedMotors(webots::Robot& robot);
  BorrowedMotors(const BorrowedMotors& other) : robot_{other.robot_}, impl_{other.impl_}, motors_{other.motors_} {}
  BorrowedMotors& operator=(const BorrowedMotors& other);
  ~BorrowedMotors() { giveBack(); }

  /// False without a robot, or after it was destroyed together with its motors.
  [[nodiscard]] bool exist() const;
  /// Which manager moves the joints now; neither if the controller itself does.
  [[nodiscard]] bool areOurs() const { return takenBy() == this; }
  [[nodiscard]] bool areAnothers() const { return takenBy() != this && takenBy() != nullptr; }

  /// Full speed (a speed limit would make the robot fall) and the walk's gains.
  void take(const darwinop::body_player::WalkPlayer& player);
  void giveBack();

  /// Cycle of the last successful reading of the board (gyroscope).
  [[nodiscard]] std::uint64_t cycleOfReading() const;
  [[nodiscard]] darwinop::body_player::Pose present() const;
  /// Of the safety layer.
  [[nodiscard]] darwinop::State state() const;
  /// Goals, P gains and full speed.
  void setGoals(const darwinop::body_player::WalkPlayer& player);
  /// The robot's time at the newest image, and the period of its loop, ms.
  [[nodiscard]] double robotMs() const;
  [[nodiscard]] double periodMs() const;
  /// See RobotImpl::carryOn().
  [[nodiscard]] bool carryOn(int ms);

 private:
  [[nodiscard]] const void* takenBy() const;

  webots::Robot* robot_ = nullptr;
  darwinop::webots_api::RobotImpl* impl_ = nullptr;
  std::array<webots::Motor*, darwinop::gait::kWalkingJoints> motors_{};
  bool taken_ = false;
};

}  // namespace managers
