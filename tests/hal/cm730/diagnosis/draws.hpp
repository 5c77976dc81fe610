// What the faults of the blind test draw: places, and faults of the virtual robot's script.
#pragma once

#include <cstddef>
#include <vector>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/drawn_robot.hpp"

namespace darwinop::cm730 {

/// A servo, which is noted as the faulty one.
inline hil::ServoOptions& anyServo(RobotDraw& drawn, Rng& rng) {
  const std::size_t i = rng.below(kJoints);
  drawn.joints.set(i);
  return drawn.board.servo[i];
}

/// The joint and those behind it in its chain.
inline std::vector<std::size_t> jointsFrom(std::size_t first) {
  std::vector<std::size_t> joints;
  for (std::size_t i = first; i < kJoints; ++i)
    if (kJointTable[i].chain == kJointTable[first].chain) joints.push_back(i);
  return joints;
}

inline hil::InjectedFault fault(hil::FaultKind kind, double at_s = 0, double amount = 0) {
  hil::InjectedFault fault;
  fault.kind = kind;
  fault.at = hil::faultTime(at_s);
  fault.amount = amount;
  return fault;
}

/// Two different servos.
inline void twoServos(Rng& rng, std::size_t& a, std::size_t& b) {
  a = rng.below(kJoints);
  b = (a + 1 + rng.below(kJoints - 1)) % kJoints;
}

}  // namespace darwinop::cm730
