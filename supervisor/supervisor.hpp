// Parent of runtime and default controller: starts them, watches them, and brings the robot to rest when the runtime
// fails.
#pragma once

#include <memory>
#include <string>

#include "runtime/clock.hpp"
#include "runtime/names.hpp"
#include "supervisor/default_controller.hpp"
#include "supervisor/journal.hpp"
#include "supervisor/log_keeper.hpp"
#include "supervisor/orders.hpp"
#include "supervisor/rescue.hpp"
#include "supervisor/runtime_child.hpp"
#include "supervisor/status.hpp"

namespace darwinop::supervisor {

struct Setup {
  std::string home;             // folder with robot.ini, default, log/
  std::string runtime_program;  // darwinop-runtime
};

/// One thread looks at everything every 20 ms and never waits; docs/supervisor.md has the picture.
class Supervisor {
 public:
  /// Throws std::runtime_error when another one runs, or the home is no folder.
  explicit Supervisor(const Setup& setup);
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// Returns when it was told to stop and all is at rest. The exit status.
  int run();

 private:
  enum class Phase {
    kRuntime,   // it starts, or its loop turns
    kBackOff,   // it could not start; the next attempt is due at next_start_
    kStopping,  // controller, then runtime are told to end
    kRescue,    // it died or hung; the robot is brought to rest
    kDown,      // at rest, nobody drives until somebody asks
    kOver,
  };

  static constexpr const char* kReady = "runtime: ready";
  static constexpr Nanos kFirstWait{2'000'000'000};         // until a runtime that cannot start is tried again
  static constexpr Nanos kTimeToReachRobot{5'000'000'000};  // of a rescue that was told to stop

  void look();
  void take(const Orders& orders);
  void startRuntime();
  void backOff(const std::string& why);
  void lookAtRuntime();
  void onRuntimeEnd(const Ending& ending);
  void endRuntime();
  void rescue(const std::string& why);
  void lookAtRescue();
  void onRest(Rescue::Step step);
  void become(Phase phase, const std::string& told);
  void publishStatus();

  Setup setup_;
  runtime::RuntimeFiles files_;
  SupervisorFiles own_;
  runtime::FileLock claim_;
  runtime::MonotonicClock clock_;
  Nanos now_{0};
  RobotSettings settings_;  // that the runtime has

  std::unique_ptr<RuntimeChild> runtime_;
  DefaultController controller_;
  std::unique_ptr<Rescue> rescue_;
  LogKeeper logs_;

  Phase phase_ = Phase::kRuntime;
  std::string told_;
  Once once_;
  Nanos next_start_{0}, start_wait_;
  Nanos kill_at_{0};         // when the runtime was told to end
  Nanos stop_rescue_at_{0};  // when told to stop in a rescue that never reached the robot
  bool stop_asked_ = false, restart_asked_ = false;
  bool failed_ = false;  // the robot could not be brought to rest
  std::string robot_;    // how it was left by the last loop, for the end of a sentence; empty: not known
  std::uint32_t orders_ = 0;
  Status published_;
};

}  // namespace darwinop::supervisor
