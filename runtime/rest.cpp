#include "runtime/rest.hpp"

#include <cmath>

#include "core/units.hpp"
#include "runtime/torque_left.hpp"

namespace darwinop::runtime {
namespace {

constexpr std::uint64_t kTakenIn = 3;  // cycles until an end of session is read, executed and reported
// Torque off is a broadcast without acknowledgement. After a round the command was repeated to those that had not
// received it.
constexpr std::uint64_t kLookedAtAll = kPollRound;
// A servo that missed it, or whose poll was lost, is asked again in the next rounds.
constexpr std::uint64_t kGivenUp = 4 * kLookedAtAll;
// After a short interruption of the line the kneel continues; after a longer one nothing is sent.
constexpr Nanos kOfflineForGood{3'000'000'000};

}  // namespace

Rest::Rest(const safety::Config& safety, Nanos period)
    : on_exit_{safety.on_exit},
      gentle_speed_{safety.gentle_speed},
      offline_cycles_{static_cast<std::uint64_t>(kOfflineForGood / period)} {}

std::uint64_t Rest::cyclesIn(State state, const Sensors& seen, std::optional<std::uint64_t>& since) noexcept {
  if (seen.safety.state != state)
    since.reset();
  else if (!since)
    since = seen.cycle;
  return since ? seen.cycle - *since : 0;
}

bool Rest::reached(const Sensors& seen) noexcept {
  if (!first_) first_ = seen.cycle;
  const std::uint64_t limp = cyclesIn(State::kLimp, seen, limp_since_);
  const std::uint64_t offline = cyclesIn(State::kOffline, seen, offline_since_);
  if (seen.cycle - *first_ < kTakenIn) return false;
  // What a fault demands goes before on_exit, as in safety.
  const bool by_fault = seen.safety.reaction >= Reaction::kKneel || seen.safety.state == State::kKneeling ||
                        seen.safety.state == State::kLimp;
  if (on_exit_ == safety::OnExit::kHold && !by_fault) return true;
  const bool all_limp = perhapsUnderTorque(seen, everAnswered(seen)).none();
  return limp >= (all_limp ? kLookedAtAll : kGivenUp) || offline >= offline_cycles_;
}

Nanos Rest::atMost(const Sensors& seen) const noexcept {
  return atMost(std::fmin(gentle_speed_, static_cast<double>(seen.safety.gentle_speed)));  // NaN: that of the robot
}

Nanos Rest::atMost(double gentle_speed) noexcept {
  // At most one turn per joint, plus half of it as margin, plus time to take over and to come to rest.
  return safety::fromSeconds(1.5 * 2 * kPi / gentle_speed + 5);
}

}  // namespace darwinop::runtime
