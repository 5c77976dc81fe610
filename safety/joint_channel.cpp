// Takeover of one joint.
#include "safety/joint_channel.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::safety {
namespace {

// Two readings agree within 4 ticks. A limb that swings faster than 0.38 rad/s (at 16 ms) is not accepted: it moves by
// the same distance again until the goal is written, and a falling limb by slightly more.
constexpr double kAgreement = 4.5 * kRadPerTick;
// Readings further apart in time are not compared.
constexpr std::uint32_t kApart = 5;  // cycles

}  // namespace

void PositionConfirmer::update(const JointSensors& seen) noexcept {
  if (!seen.motion.fresh() || !std::isfinite(seen.position.value)) {
    confirmed_.reset();
    if (++missed_ > kApart) forget();
    return;
  }
  const bool agrees = last_.known() && std::abs(seen.position.value - last_.value) <= kAgreement;
  confirmed_ = agrees ? std::optional{seen.position} : std::nullopt;
  last_ = seen.position;
  missed_ = 0;
}

void JointChannel::restart() noexcept {
  phase_ = Phase::kConfirming;
  confirmer_.forget();
}

void JointChannel::place(const JointRange& range) noexcept {
  goal_ = Rad{std::clamp(confirmer_.confirmed()->value, range.low.value, range.high.value)};
  phase_ = Phase::kPlaced;
}

void JointChannel::torqueOn() noexcept {
  phase_ = Phase::kGentle;
  driven_for_ = Nanos{0};
}

}  // namespace darwinop::safety
