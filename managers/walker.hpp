// Inside of the gait manager: a walk on a robot, driven by the manager, by Robot::step(), or by the end of the session.
#pragma once

#include <string>

#include "managers/body_player/following.hpp"
#include "managers/body_player/walk_player.hpp"
#include "managers/borrowed_motors.hpp"
#include "managers/step_clock.hpp"
#include "webots/step_observer.hpp"

namespace webots {
class Gyro;
}

namespace managers {

/// Logs once.
void warnOfGait(const std::string& what);

/// All members are for the manager.
struct GaitWalker : darwinop::webots_api::StepObserver {
  webots::Robot* robot = nullptr;  // null: not initialized
  BorrowedMotors motors;
  webots::Gyro* gyro = nullptr;
  darwinop::body_player::WalkPlayer player{darwinop::gait::Parameters{}};
  darwinop::gait::WalkCommand command;
  StepClock clock;
  darwinop::body_player::Following following;
  bool balance = true;
  bool requested = false;  // between start() and stop()
  bool stopping = false;   // inside stop(), to reject calls from an overridden Robot::step()
  bool stepped = false;    // the controller calls step(); otherwise Robot::step() walks
  bool slow_warned = false;

  GaitWalker() = default;
  /// The same robot and commands, at rest.
  GaitWalker(const GaitWalker& other)
      : StepObserver{},  // NOLINT(readability-redundant-member-init): g++ warns without it
        robot{other.robot},
        motors{other.motors},
        gyro{other.gyro},
        player{other.player.parameters()},
        command{other.command},
        balance{other.balance} {}
  GaitWalker& operator=(const GaitWalker&) = delete;
  /// A walk ends on both feet.
  ~GaitWalker() override { finish(); }

  /// Reads the file and enables the gyroscope. Throws std::runtime_error.
  void prepare(webots::Robot& with, const std::string& ini);

  [[nodiscard]] const darwinop::gait::Walk& walk() const { return player.walk(); }
  [[nodiscard]] bool canWalk() const { return robot != nullptr && motors.exist() && !stopping; }

  /// One step of `ms`, or of the robot's time if that is longer. `ms`: at least 0.
  void step(int ms);
  /// Finishes the steps; calls Robot::step().
  void stop();
  /// As stop(), without the controller's Robot, which may be half destroyed; then waits until the robot stands still.
  void finish();

  /// Code of the robot of 2013 need not call step() of the manager: there a thread walked.
  void beforeStep(int ms) override {
    if (canWalk() && requested && !stepped && ms > 0) step(ms);
  }
  void beforeEnd() override { finish(); }

 private:
  [[nodiscard]] bool waitsForRobot(double ms);
  void begin();
  void advance(double ms);
  void warnIfSlow(int ms);
  /// The command; with shorter strides in a very slow loop.
  [[nodiscard]] darwinop::gait::WalkCommand pacedCommand() const;
  [[nodiscard]] darwinop::body_player::GyroReading gyroReading() const;
};

}  // namespace managers
