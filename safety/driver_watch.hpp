// Watchdog of the driving session: which session drives, whether it is alive, and whether it requests a fault reset.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/commands.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

class DriverWatch {
 public:
  /// `config` must outlive this object and may change; also for all other parts of the guard.
  explicit DriverWatch(const Config& config) : config_{config} {}

  /// Once a cycle. `excused`: safety moves the robot, so silence does not count.
  void update(const Commands& asked, bool excused, Nanos dt) noexcept {
    came_ = asked.session != 0 && asked.session != session_;
    const bool same = session_ != 0 && asked.session == session_;
    // A session that was given up or has ended stays so: a controller that resumes must not raise a robot that sits
    // limp, perhaps in somebody's hands, nor switch torque in the kneel. The image that ends it still counts.
    obeyed_ = came_ || (same && !ended_ && !gone());
    // Heartbeat: only an increased sequence number counts, because the last image of a dead controller remains.
    const bool alive = came_ || (obeyed_ && asked.sequence > sequence_);
    const bool by_driver = came_ || (same && asked.fault_resets != resets_);
    reset_asked_ = (by_driver && !asked.unattended) || asked.operator_resets != operator_resets_;
    // The loop lets no session pass that began before a release: one that comes in the same image began after it.
    released_ = asked.operator_releases != operator_releases_ && !(came_ && !asked.unattended);
    operator_resets_ = asked.operator_resets;
    operator_releases_ = asked.operator_releases;
    if (came_ || same) {
      session_ = asked.session;
      sequence_ = came_ ? asked.sequence : std::max(sequence_, asked.sequence);
      resets_ = asked.fault_resets;
      ended_ = asked.end_of_session || (ended_ && !came_);
    }
    // A release ends the session permanently; so does the end of a loop that no session ever drove.
    ended_ = ended_ || released_ || (session_ == 0 && asked.end_of_session);
    if (alive || ended_ || session_ == 0)
      silence_ = Nanos{0};
    else if (!excused)
      silence_ += dt;
  }

  /// Ends the session: there is nothing to hold.
  void end() noexcept { ended_ = true; }

  /// True in the cycle in which a new session is first seen.
  [[nodiscard]] bool came() const noexcept { return came_; }
  /// True if this cycle's image is of the session that drives, or ends it.
  [[nodiscard]] bool obeyed() const noexcept { return obeyed_; }
  /// A fault reset is requested. A new session started by a person counts as a request: a person has checked the robot.
  [[nodiscard]] bool resetAsked() const noexcept { return reset_asked_; }
  /// True in the cycle in which an operator releases the robot.
  [[nodiscard]] bool released() const noexcept { return released_; }
  [[nodiscard]] bool stalled() const noexcept { return silence_ >= fromSeconds(config_.stall_ms / 1000); }
  /// From then on only a new session can drive.
  [[nodiscard]] bool gone() const noexcept { return silence_ >= fromSeconds(config_.gone_s); }
  /// The session has ended; only a new one can drive.
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
