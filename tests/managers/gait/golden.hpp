// Goals recorded from the reference, call by call: golden_gait.csv.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "managers/gait/goals.hpp"

namespace darwinop::gait {

struct GoldenCall {
  std::string scenario;
  int call = 0;
  bool running_after = false;
  std::array<int, kWalkingJoints> tick{};
};

/// Throws std::runtime_error when the file is missing or is not what it should be.
std::vector<GoldenCall> goldenCalls();

/// A real gait configuration: the files shipped with the simulator do not balance sideways.
inline Parameters shipped() {
  Parameters p;
  p.balance_hip_roll_gain = p.balance_ankle_roll_gain = 0;
  return p;
}

}  // namespace darwinop::gait
