// Detects that a servo has shut itself off, from two sources: the error byte of every reply, and the torque registers
// of the round-robin poll. One reading raises a suspicion; a second one in a row confirms it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/packet.hpp"
#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/debounce.hpp"

namespace darwinop::safety {

class TripWatch {
 public:
  enum class Verdict : std::uint8_t {
    kFine,
    kSuspected,  // write nothing until the next reading: a routine write would switch torque on again
    kOverload,   // shut itself off
    kOverheat,   // shut itself off
    kNotOn,      // torque is off but the torque limit is not 0: "torque on" was lost
  };

  /// Once a cycle. `driven_for`: time since torque was switched on; empty while the joint is not driven.
  Verdict update(const JointSensors& seen, std::optional<Nanos> driven_for) noexcept {
    const bool armed = driven_for && *driven_for >= kGrace;
    if (!driven_for) {
      off_.forget();
      was_on_ = false;
    }
    if (seen.motion.fresh()) noteErrorBits(seen, armed);
    if (!driven_for || armed)
      early_ = false;
    else if (seen.motion.fresh())
      early_ = (seen.polled.fresh() && seen.torque_limit.value <= 0) || (seen.error_bits & error_bit::kOverload) != 0;
    if (armed && seen.polled.fresh()) notePoll(seen);
    if (bits_.on()) return (last_bits_ & error_bit::kOverheat) != 0 ? Verdict::kOverheat : Verdict::kOverload;
    if (off_.on()) return judgePoll(seen);
    return early_ || bits_.suspected() || off_.suspected() ? Verdict::kSuspected : Verdict::kFine;
  }
  /// After a reset: use only readings from now on.
  void forget() noexcept { *this = TripWatch{}; }

  /// An overload bit counts only from this time after torque on. With torque off there is no load, so a bit that is
  /// still set is left over from before; the servo clears it when torque comes on.
  static constexpr Nanos kGrace{std::chrono::milliseconds{300}};

 private:
  void noteErrorBits(const JointSensors& seen, bool armed) noexcept {
    const int shutdown = error_bit::kOverheat | (armed ? error_bit::kOverload : 0);
    const auto bits = static_cast<std::uint8_t>(seen.error_bits & shutdown);
    if (bits != 0) last_bits_ = bits;
    bits_.update(bits != 0, bits == 0);
  }
  void notePoll(const JointSensors& seen) noexcept {
    limit_zero_ = seen.torque_limit.value <= 0;
    const bool off = !seen.torque_enabled || limit_zero_;
    off_.update(off, !off);
    was_on_ = was_on_ || !off;
  }
  [[nodiscard]] Verdict judgePoll(const JointSensors& seen) const noexcept {
    // A restarted servo has missed replies before (JointGuard); one that shut itself off keeps replying.
    if (!limit_zero_ && !was_on_) return Verdict::kNotOn;
    return (seen.error_bits & error_bit::kOverheat) != 0 ? Verdict::kOverheat : Verdict::kOverload;
  }

  Confirm bits_, off_;
  bool early_ = false;   // overload bit within kGrace: left over, or the servo has shut itself off already
  bool was_on_ = false;  // torque was seen on since it was switched on
  bool limit_zero_ = false;
  std::uint8_t last_bits_ = 0;
};

}  // namespace darwinop::safety
