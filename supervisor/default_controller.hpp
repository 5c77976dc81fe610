// State machine of the default controller: waits for the start pose, runs, restarts after a crash, gives up.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "core/sensors.hpp"
#include "hal/process/child_process.hpp"
#include "runtime/names.hpp"
#include "safety/start_pose.hpp"
#include "supervisor/holder.hpp"
#include "supervisor/journal.hpp"
#include "supervisor/restart_policy.hpp"
#include "supervisor/status.hpp"

namespace darwinop::supervisor {

class DefaultController {
 public:
  /// `home`/default is a link to its folder; output goes to `home`/log/controller.log.
  DefaultController(std::string home, const runtime::RuntimeFiles& files);

  /// Start pose within the limits of the runtime's loop; call when its first cycle has run.
  void startsFrom(const std::array<Rad, kJoints>& pose) { start_pose_ = pose; }
  /// Call while the runtime's loop runs, with its newest image.
  void update(const Sensors& seen, Nanos now);
  /// Call while there is no loop, so that the controller's end is noticed.
  void updateWithoutRuntime(Nanos now);

  /// Starts to end it; the robot sits down. It stays ended.
  void stop(Nanos now);
  /// Ends it if it runs, and starts again from the start pose.
  void restart(Nanos now);
  /// For a person. Without a loop it resets nothing: call again when one runs.
  void resetFaults();
  /// Call before the first update: only restart() starts it, if there is one.
  void stayEnded(const std::string& why) {
    if (!folder().empty()) become(State::kOver, why);
  }
  /// The loop is gone: the controller cannot drive, and its exit status is not evaluated.
  void runtimeLost(Nanos now);

  /// No process of it exists, and the robot is not held in its place.
  [[nodiscard]] bool over() const { return state_ == State::kOver; }
  /// It was stopped, even if it is still ending, has ended or has failed: only restart() starts it again.
  [[nodiscard]] bool staysEnded() const {
    return over() || state_ == State::kHeld || (state_ == State::kEnding && !again_);
  }
  void report(Status& status, Nanos now) const;

 private:
  enum class State {
    kWaiting,  // for a person, the start pose, the end of another controller, or the pause after a crash
    kRunning,
    kEnding,  // SIGTERM sent
    kHeld,    // given up; the robot is held
    kOver,
  };

  /// Target of `home`/default; empty: there is no default controller.
  [[nodiscard]] std::string folder() const;
  [[nodiscard]] bool ready(const Sensors& seen, Nanos now);
  [[nodiscard]] bool sits(const Sensors& seen, Nanos now);
  bool waitFor(const std::string& what, const std::string& details = "");
  void begin(Nanos now);
  bool chooseAccount(process::Start& start);
  void onEnd(const process::Ending& ending, Nanos now);
  void forgetChild(const process::Ending& ending);
  void end(Nanos now);
  void whileEnding(bool loop_turns, Nanos now);
  void endSession();
  void hold();
  void become(State state, const std::string& text);

  std::string home_;
  std::array<Rad, kJoints> start_pose_ = safety::startPose(safety::Config{});
  runtime::RuntimeFiles files_;
  RestartPolicy policy_;
  State state_ = State::kWaiting;
  std::string state_text_ = "waiting for the runtime", name_;
  std::unique_ptr<process::ChildProcess> child_;
  std::unique_ptr<Holder> holder_;
  Once once_;
  Nanos not_before_{0};                 // time of the next start
  std::optional<Nanos> in_pose_since_;  // the robot is in its start pose
  std::optional<Nanos> latched_at_;     // last time in this run that a fault needed user action
  Nanos kill_at_{0};                    // time of SIGKILL
  bool again_ = false;                  // restart after its end
  bool may_hold_ = true;                // no person has released the robot from the holder
};

}  // namespace darwinop::supervisor
