// Progress of a rescue.
#include "supervisor/rescue_watch.hpp"

#include <algorithm>

namespace darwinop::supervisor {
namespace {

// After two rounds each reading is newer than the torque switch.
constexpr std::uint64_t kTwoRounds = 2 * kPollRound;

std::uint64_t cyclesIn(Nanos time, Nanos period) {
  return static_cast<std::uint64_t>(time / period);
}

}  // namespace

bool anyStiff(const Sensors& seen) noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    const bool is_answering = joint.motion.ever() && joint.motion.age < kTwoRounds && joint.polled.ever();
    if (is_answering && joint.torque_enabled) return true;
  }
  return false;
}

RescueWatch::RescueWatch(Nanos period, Nanos crouch_at_most)
    : hold_{std::max(cyclesIn(kHold, period), kTwoRounds)},
      settled_{kTwoRounds},
      at_most_{cyclesIn(crouch_at_most, period) + kTwoRounds} {}

RescueWatch::Step RescueWatch::update(const Sensors& seen) noexcept {
  const std::uint64_t passed = seen.cycle - std::min(last_, seen.cycle);
  last_ = seen.cycle;
  online_ = seen.cycle != 0 && seen.safety.state != State::kOffline;
  if (!online_) {
    // The safety layer restarts its crouch when the board is back; so does the time limit: a robot on a bad cable is
    // never given up.
    limp_ = 0;
    crouching_ = std::min<std::uint64_t>(crouching_, 1);
    return crouching_ > 0 ? Step::kCrouch : Step::kHold;
  }
  answered_cycles_ += passed;
  if (answered_cycles_ <= hold_) return Step::kHold;
  crouching_ += passed;
  limp_ = seen.safety.state == State::kLimp && !anyStiff(seen) ? limp_ + passed : 0;
  if (limp_ >= settled_) return Step::kAtRest;
  return crouching_ > at_most_ ? Step::kStiff : Step::kCrouch;
}

}  // namespace darwinop::supervisor
