// Finds out that a servo has shut itself off.
#include "safety/trip_watch.hpp"

#include "core/conversions.hpp"
#include "core/packet.hpp"

namespace darwinop::safety {

TripWatch::Verdict TripWatch::update(const JointSensors& seen, std::optional<Nanos> driven_for) noexcept {
  const bool armed = driven_for && *driven_for >= kGrace;
  if (!driven_for) {
    off_.forget();
    was_on_ = false;
  }
  if (seen.motion.fresh()) {
    const auto shutdown = static_cast<std::uint8_t>(error_bit::kOverheat | (armed ? error_bit::kOverload : 0));
    if (const auto bits = static_cast<std::uint8_t>(seen.error_bits & shutdown); bits != 0) last_bits_ = bits;
    bits_.update((seen.error_bits & shutdown) != 0, (seen.error_bits & shutdown) == 0);
  }
  if (!driven_for || armed)
    early_ = false;
  else if (seen.motion.fresh())
    early_ = (seen.health.fresh() && seen.torque_limit.value <= 0) || (seen.error_bits & error_bit::kOverload) != 0;
  if (armed && seen.health.fresh()) {
    const bool off = !seen.torque_enabled || seen.torque_limit.value <= 0;
    limit_zero_ = seen.torque_limit.value <= 0;
    off_.update(off, !off);
    was_on_ = was_on_ || !off;
  }
  if (bits_.on()) return (last_bits_ & error_bit::kOverheat) != 0 ? Verdict::kOverheat : Verdict::kOverload;
  if (off_.on()) return judgeLook(seen);
  return early_ || bits_.suspected() || off_.suspected() ? Verdict::kSuspect : Verdict::kFine;
}

TripWatch::Verdict TripWatch::judgeLook(const JointSensors& seen) noexcept {
  // A servo that has restarted was missed before (JointGuard); one that shut itself off goes on answering.
  if (!limit_zero_ && !was_on_) return Verdict::kNotOn;
  return (seen.error_bits & error_bit::kOverheat) != 0 ? Verdict::kOverheat : Verdict::kOverload;
}

}  // namespace darwinop::safety
