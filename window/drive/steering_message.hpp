// Requests of a page on the steering channel: {"take": true}, {"goals": {"Neck": 0.3}}, {"walk": {"x": 0.5}}, {"page":
// 9},
// {"torque": {"left_arm": false}}, {"leave": true}, {"stop": true}, or {} as heartbeat.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "window/drive/drive_interface.hpp"

namespace darwinop::window {

struct SteeringMessage {
  bool take = false;         // start driving
  bool stop = false;         // hold at once and give the lease back
  bool leave = false;        // the same after the present steps
  DriveRequests requests{};  // without "walk" the robot stands
};

/// "right_arm"
[[nodiscard]] std::string_view limbName(std::size_t limb);

/// Nullopt: invalid, with the reason in `why`; nothing of it is applied.
[[nodiscard]] std::optional<SteeringMessage> parseSteering(std::string_view text, std::string& why);

}  // namespace darwinop::window
