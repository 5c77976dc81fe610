// What a page may say on the steering channel: {"take": true}, {"goals": {"Neck": 0.3}}, {"stop": true}, or {}: I am
// here.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/joints.hpp"
#include "core/units.hpp"

namespace darwinop::window {

struct SteeringWords {
  bool take = false;  // become the one who drives
  bool stop = false;  // hold the robot, give the lease back
  std::vector<std::pair<Joint, Rad>> goals;
};

/// Nothing, and `why`: it was not understood, and nothing of it counts.
[[nodiscard]] std::optional<SteeringWords> readSteering(std::string_view text, std::string& why);

}  // namespace darwinop::window
