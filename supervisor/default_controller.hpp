// The default controller's life: waits for the start pose, runs, is started again after a crash, is given up.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/sensors.hpp"
#include "runtime/names.hpp"
#include "supervisor/child.hpp"
#include "supervisor/holder.hpp"
#include "supervisor/journal.hpp"
#include "supervisor/restart_policy.hpp"
#include "supervisor/status.hpp"

namespace darwinop::supervisor {

class DefaultController {
 public:
  /// `home`/default leads to its folder; its output goes to `home`/log/controller.log.
  DefaultController(std::string home, const runtime::RuntimeFiles& files);

  /// While the runtime's loop turns, with its newest image.
  void look(const Sensors& seen, Nanos now);
  /// While there is no loop, so that one that ends is noticed all the same.
  void lookWithoutRuntime(Nanos now);

  /// Begins to end it, and the robot sits down; it stays ended.
  void stop(Nanos now);
  /// Another chance: ends it if it runs, and begins anew with the start pose.
  void restart(Nanos now);
  /// The loop is gone: it has nothing to drive any more, and how it ends says nothing about it.
  void runtimeLost(Nanos now);

  /// No process of it is left, and none is held in its place.
  [[nodiscard]] bool over() const { return state_ == State::kOver; }
  void tell(Status& status, Nanos now) const;

 private:
  enum class State {
    kWaiting,  // for a person, for the start pose, for another controller to end, for the pause after a crash
    kRunning,
    kEnding,  // was told to end
    kHeld,    // given up; the robot is held in its place
    kOver,
  };

  /// That `home`/default leads to; empty: there is no default controller.
  [[nodiscard]] std::string folder() const;
  [[nodiscard]] bool ready(const Sensors& seen, Nanos now);
  [[nodiscard]] bool sits(const Sensors& seen, Nanos now);
  bool waitFor(const std::string& what, const std::string& details = "");
  void begin(Nanos now);
  bool chooseAccount(Start& start);
  void onEnd(const Ending& ending, Nanos now);
  void resetFaults();
  void end(Nanos now);
  void whileEnding(bool loop_turns, Nanos now);
  void sitDown();
  void hold();
  void become(State state, const std::string& told);

  std::string home_;
  runtime::RuntimeFiles files_;
  RestartPolicy policy_;
  State state_ = State::kWaiting;
  std::string told_ = "waits for the runtime", name_;
  std::unique_ptr<Child> child_;
  std::unique_ptr<Holder> holder_;
  Once once_;
  Nanos not_before_{0};                 // of the next start
  std::optional<Nanos> in_pose_since_;  // the robot sits ready
  std::optional<Nanos> latched_at_;     // when a fault that waits for a person was last seen during this run
  Nanos kill_at_{0};                    // when it was told to end and does not
  bool again_ = false;                  // after it has ended
  bool may_hold_ = true;                // nobody has taken the robot from the holder
};

}  // namespace darwinop::supervisor
