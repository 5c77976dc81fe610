// What a page may say on the steering channel: {"take": true}, {"goals": {"Neck": 0.3}}, {"walk": {"x": 0.5}},
// {"page": 9}, {"torque": {"left_arm": false}}, {"leave": true}, {"stop": true}, or {}: I am here.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "window/helm.hpp"

namespace darwinop::window {

struct SteeringWords {
  bool take = false;   // become the one who drives
  bool stop = false;   // hold the robot, give the lease back
  bool leave = false;  // the same, after the steps under way
  Orders orders{};     // one who says nothing of walking wants to stand
};

/// "right_arm"
[[nodiscard]] std::string_view limbName(std::size_t limb);

/// Nothing, and `why`: it was not understood, and nothing of it counts.
[[nodiscard]] std::optional<SteeringWords> readSteering(std::string_view text, std::string& why);

}  // namespace darwinop::window
