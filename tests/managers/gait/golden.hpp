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

/// Throws std::runtime_error if the file is missing or invalid.
std::vector<GoldenCall> goldenCalls();

/// A gait configuration for the real robot; the files shipped with the simulator have no lateral balance.
inline Parameters shipped() {
  Parameters p;
  p.balance_hip_roll_gain = p.balance_ankle_roll_gain = 0;
  return p;
}

}  // namespace darwinop::gait
