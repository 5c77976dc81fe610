#include "hil-mocks/random_fault.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::hil {
namespace {

// After a shutdown a servo reports it for longer than this: it cools slowly, and the overload bit stays.
constexpr Nanos kShortestCause = std::chrono::milliseconds{600};

/// One servo, or servos that fail together: a connector, a chain, both legs, all, or a random set.
std::bitset<kJoints> randomJoints(Rng& random) noexcept {
  std::bitset<kJoints> joints;
  const std::size_t first = random.below(kJoints);
  const std::size_t way = random.below(8);
  const std::uint64_t any = random.next();
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointRow &one = kJointTable[first], &other = kJointTable[i];
    const bool same_chain = one.chain == other.chain;
    const bool leg = other.chain == Chain::kRightLeg || other.chain == Chain::kLeftLeg;
    joints[i] = i == first || (way == 0 && same_chain && i >= first) || (way == 1 && same_chain) || (way == 2 && leg) ||
                way == 3 || (way == 4 && ((any >> i) & 1) != 0);
  }
  return joints;
}

}  // namespace

InjectedFault randomFault(FaultKind kind, Nanos at, Rng& random) noexcept {
  InjectedFault fault;
  fault.at = at;
  fault.kind = kind;
  fault.lasts = faultTime(random.between(0.02, 2.0));
  fault.joints = randomJoints(random);
  fault.fall = static_cast<Fall>(random.below(4));
  fault.way = static_cast<Way>(1 + random.below(3));
  fault.bits = static_cast<std::uint8_t>(random.below(128));
  fault.chance = 0.01 + 0.2 * random.uniform();
  fault.amount = 1 + static_cast<double>(random.below(8));  // bytes or ms
  if (kind == FaultKind::kHeat) {
    fault.amount = random.between(40, 90);
    fault.lasts = std::max(fault.lasts, kShortestCause);
  }
  if (kind == FaultKind::kVoltage) fault.amount = random.between(5, 16.5);
  if (kind == FaultKind::kJam) fault.amount = random.between(0.35, 2);
  if (kind == FaultKind::kSag) fault.amount = random.between(1, 60);
  if (kind == FaultKind::kErrors && random.below(2) == 0) {
    fault.chance = 1;
    fault.lasts = std::max(fault.lasts, kShortestCause);
  }
  if (kind == FaultKind::kDead) {  // 1 ms to 1 s, log-uniform
    fault.lasts = faultTime(0.001 * std::pow(10.0, random.between(0, 3)));
    fault.boot = faultTime(random.between(0.005, 0.5));
  }
  if (kind == FaultKind::kButton) fault.bits = static_cast<std::uint8_t>(1 + random.below(3));
  return fault;
}

}  // namespace darwinop::hil
