// Parent of runtime and default controller: starts and monitors them, and brings the robot to rest if the runtime
// fails.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "runtime/clock.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/names.hpp"
#include "runtime/torque_left.hpp"
#include "supervisor/default_controller.hpp"
#include "supervisor/journal.hpp"
#include "supervisor/log_keeper.hpp"
#include "supervisor/orders.hpp"
#include "supervisor/phases.hpp"
#include "supervisor/rescue.hpp"
#include "supervisor/runtime_child.hpp"
#include "supervisor/status.hpp"

namespace darwinop::supervisor {

struct Setup {
  std::string home;             // folder with robot.ini, default, log/
  std::string runtime_program;  // darwinop-runtime
};

/// One thread checks everything every 20 ms; it waits for locks and ports up to a second; diagram in
/// docs/supervisor.md.
class Supervisor {
 public:
  /// Throws std::runtime_error if another supervisor runs, or if the home is not a folder.
  explicit Supervisor(const Setup& setup);
  ~Supervisor() = default;
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// Returns after a stop command, when all has ended. Exit status 0: the robot is at rest; runtime::kExitUnderTorque:
  /// joints may be under torque.
  int run();

 private:
  static constexpr Nanos kFirstWait{2'000'000'000};         // before a failed start is retried
  static constexpr Nanos kTimeToReachRobot{5'000'000'000};  // limit for a rescue after a stop command

  static constexpr std::string_view kSeparator = "; ";  // before the state of the robot

  void update();
  void take(const Orders& orders);
  void startRuntime();
  void backOff(const std::string& why);
  void updateRuntime();
  void onRuntimeEnd(const process::Ending& ending);
  void endRuntime();
  void rescue(const std::string& why);
  void updateRescue();
  void onRest(Rescue::Step step);
  void noteRobot(const runtime::JointSet& under_torque);
  void endAll();
  void onEvent(PhaseEvent event, const std::string& text);
  void publishStatus();

  Setup setup_;
  runtime::RuntimeFiles files_;
  SupervisorFiles own_;
  runtime::FileLock claim_;
  runtime::MonotonicClock clock_;
  Nanos now_{0};
  RobotSettings settings_;  // as used by the runtime

  std::unique_ptr<RuntimeChild> runtime_;
  DefaultController controller_;
  std::unique_ptr<Rescue> rescue_;
  LogKeeper logs_;

  SupervisorPhase phase_ = SupervisorPhase::kStarting;
  std::string state_text_;  // of the last event, for people
  Once once_;
  Nanos next_start_{0}, start_wait_;
  Nanos kill_at_{0};         // time of SIGKILL for the runtime
  Nanos stop_rescue_at_{0};  // after a stop command in a rescue that has not reached the robot
  bool stop_asked_ = false, restart_asked_ = false;
  bool reset_asked_ = false;   // a restart was asked before the loop's first cycle
  bool stays_ended_ = false;   // the controller was not to run when the stop command came
  bool failed_ = false;        // joints may be under torque
  runtime::JointSet present_;  // servos that answered the runtime which the rescue follows
  std::string robot_;          // state after the last loop, as the end of a message; empty: unknown
  std::uint32_t orders_ = 0;
  Status published_;
};

}  // namespace darwinop::supervisor
