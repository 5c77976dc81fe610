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
    missed_ = 0;
  }
  if (seen.motion.fresh()) {
    const auto shutdown = static_cast<std::uint8_t>(error_bit::kOverheat | (armed ? error_bit::kOverload : 0));
    if (const auto bits = static_cast<std::uint8_t>(seen.error_bits & shutdown); bits != 0) last_bits_ = bits;
    bits_.update((seen.error_bits & shutdown) != 0, (seen.error_bits & shutdown) == 0);
  } else if (missed_ < 1000) {
    ++missed_;
  }
  if (armed && seen.health.fresh()) {
    const bool off = !seen.torque_enabled || seen.torque_limit.value <= 0;
    limit_zero_ = seen.torque_limit.value <= 0;
    off_.update(off, !off);
    if (!off) {
      was_on_ = true;
      missed_ = 0;
    }
  }
  if (bits_.on()) return (last_bits_ & error_bit::kOverheat) != 0 ? Verdict::kOverheat : Verdict::kOverload;
  if (off_.on()) return judgeLook(seen);
  return bits_.suspected() || off_.suspected() ? Verdict::kSuspect : Verdict::kFine;
}

TripWatch::Verdict TripWatch::judgeLook(const JointSensors& seen) noexcept {
  // A servo that restarts is deaf for longer than this many cycles; one that shut itself off goes on answering.
  constexpr std::uint32_t kRestart = 3;
  if (!limit_zero_ && (!was_on_ || missed_ >= kRestart)) return Verdict::kLostPower;
  return (seen.error_bits & error_bit::kOverheat) != 0 ? Verdict::kOverheat : Verdict::kOverload;
}

}  // namespace darwinop::safety
