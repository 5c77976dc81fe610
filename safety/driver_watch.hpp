// Who drives, whether they are still there, and whether they ask for faults to be cleared.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/commands.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

class DriverWatch {
 public:
  explicit DriverWatch(const Config& config)
      : stall_{fromSeconds(config.stall_ms / 1000)}, gone_{fromSeconds(config.gone_s)} {}

  /// Once a cycle. `excused`: the robot moves by itself and a controller may well wait for that in silence.
  void update(const Commands& asked, bool excused, Nanos dt) noexcept {
    came_ = asked.session != 0 && asked.session != session_;
    obeyed_ = came_ || (session_ != 0 && asked.session == session_);
    // Only a number that grew is a sign of life: an image left behind by a dead controller is none.
    const bool alive = came_ || (obeyed_ && !ended_ && asked.sequence > sequence_);
    reset_asked_ = came_ || (obeyed_ && asked.fault_resets != resets_);
    if (obeyed_) {
      session_ = asked.session;
      sequence_ = came_ ? asked.sequence : std::max(sequence_, asked.sequence);
      resets_ = asked.fault_resets;
      ended_ = asked.farewell || (ended_ && !came_);
    }
    silence_ = alive || excused || ended_ || session_ == 0 ? Nanos{0} : silence_ + dt;
  }

  /// True in the cycle in which a new session is first seen.
  [[nodiscard]] bool came() const noexcept { return came_; }
  /// True when this cycle's image is that of the session that is obeyed.
  [[nodiscard]] bool obeyed() const noexcept { return obeyed_; }
  /// A new session is a request, too: who starts a controller has seen to the robot.
  [[nodiscard]] bool resetAsked() const noexcept { return reset_asked_; }
  [[nodiscard]] bool stalled() const noexcept { return silence_ >= stall_; }
  [[nodiscard]] bool gone() const noexcept { return silence_ >= gone_; }
  /// The controller said farewell; only a new session counts from here on.
  [[nodiscard]] bool ended() const noexcept { return ended_; }
  [[nodiscard]] bool present() const noexcept { return session_ != 0 && !ended_ && !gone(); }
  [[nodiscard]] std::uint32_t session() const noexcept { return session_; }

 private:
  Nanos stall_, gone_, silence_{0};
  std::uint64_t sequence_ = 0;
  std::uint32_t session_ = 0, resets_ = 0;
  bool came_ = false, obeyed_ = false, reset_asked_ = false, ended_ = false;
};

}  // namespace darwinop::safety
