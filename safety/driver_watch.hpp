// Who drives, whether they are still there, and whether they ask for faults to be cleared.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/commands.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

class DriverWatch {
 public:
  /// `config` must outlive it and may change; the same holds for all parts of the guard.
  explicit DriverWatch(const Config& config) : config_{config} {}

  /// Once a cycle. `excused`: the robot moves by itself and a controller may well wait for that in silence.
  void update(const Commands& asked, bool excused, Nanos dt) noexcept {
    came_ = asked.session != 0 && asked.session != session_;
    obeyed_ = came_ || (session_ != 0 && asked.session == session_);
    // Only a number that grew is a sign of life: an image left behind by a dead controller is none.
    const bool alive = came_ || (obeyed_ && !ended_ && asked.sequence > sequence_);
    const bool by_driver = came_ || (obeyed_ && asked.fault_resets != resets_);
    reset_asked_ = (by_driver && !asked.unattended) || asked.operator_resets != operator_resets_;
    released_ = asked.operator_releases != operator_releases_;
    operator_resets_ = asked.operator_resets;
    operator_releases_ = asked.operator_releases;
    if (obeyed_) {
      session_ = asked.session;
      sequence_ = came_ ? asked.sequence : std::max(sequence_, asked.sequence);
      resets_ = asked.fault_resets;
      ended_ = asked.end_of_session || (ended_ && !came_);
    }
    // A released session is over for good, and so is a loop that closes although nobody has ever driven it.
    ended_ = ended_ || released_ || (session_ == 0 && asked.end_of_session);
    silence_ = alive || excused || ended_ || session_ == 0 ? Nanos{0} : silence_ + dt;
  }

  /// True in the cycle in which a new session is first seen.
  [[nodiscard]] bool came() const noexcept { return came_; }
  /// True when this cycle's image is that of the session that is obeyed.
  [[nodiscard]] bool obeyed() const noexcept { return obeyed_; }
  /// A new session that a person started is a request also: that person has seen to the robot.
  [[nodiscard]] bool resetAsked() const noexcept { return reset_asked_; }
  /// True in the cycle in which an operator releases the robot.
  [[nodiscard]] bool released() const noexcept { return released_; }
  [[nodiscard]] bool stalled() const noexcept { return silence_ >= fromSeconds(config_.stall_ms / 1000); }
  [[nodiscard]] bool gone() const noexcept { return silence_ >= fromSeconds(config_.gone_s); }
  /// The controller has ended its session; only a new one counts from here on.
  [[nodiscard]] bool ended() const noexcept { return ended_; }
  [[nodiscard]] bool present() const noexcept { return session_ != 0 && !ended_ && !gone(); }
  [[nodiscard]] std::uint32_t session() const noexcept { return session_; }

 private:
  const Config& config_;
  Nanos silence_{0};
  std::uint64_t sequence_ = 0;
  std::uint32_t session_ = 0, resets_ = 0, operator_resets_ = 0, operator_releases_ = 0;
  bool came_ = false, obeyed_ = false, reset_asked_ = false, released_ = false, ended_ = false;
};

}  // namespace darwinop::safety
