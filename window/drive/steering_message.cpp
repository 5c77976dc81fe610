// Parser of requests on the steering channel.
#include "window/drive/steering_message.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "core/text/joined.hpp"

namespace darwinop::window {
namespace {

using Json = nlohmann::json;

constexpr int kLastPage = 255;

/// Each parser returns an error text or an empty string.
std::string takeGoals(const Json& goals, DriveRequests& requests) {
  if (!goals.is_object()) return "\"goals\" must be an object: {\"Neck\": 0.3}";
  for (const auto& [name, angle] : goals.items()) {
    const std::optional<Joint> joint = findJoint(name);
    if (!joint) return "unknown joint; \"hello\" of the monitor lists them";
    if (!angle.is_number() || !std::isfinite(angle.get<double>())) return "a goal must be a number, in rad";
    requests.goals[index(*joint)] = Rad{angle.get<double>()};
  }
  return {};
}

std::string takeWalk(const Json& walk, DriveRequests& requests) {
  gait::WalkCommand amplitudes;
  if (!walk.is_object()) return "\"walk\" must be an object: {\"x\": 0.5}";
  for (const auto& [name, amplitude] : walk.items()) {
    double* const field = name == "x"   ? &amplitudes.x
                          : name == "y" ? &amplitudes.y
                          : name == "a" ? &amplitudes.a
                                        : nullptr;
    if (field == nullptr) return "unknown member of \"walk\"; use x (forward), y (left) and a (turn left)";
    if (!amplitude.is_number() || !std::isfinite(amplitude.get<double>())) return "an amplitude must be a number";
    *field = std::clamp(amplitude.get<double>(), -1.0, 1.0);
  }
  requests.walk = amplitudes;
  return {};
}

std::string takePage(const Json& page, DriveRequests& requests) {
  if (!page.is_number_integer() || page.get<std::int64_t>() < 1 || page.get<std::int64_t>() > kLastPage)
    return "\"page\" must be a number from 1 to 255";
  requests.page = page.get<int>();
  return {};
}

std::string takeTorque(const Json& torque, DriveRequests& requests) {
  if (!torque.is_object()) return "\"torque\" must be an object: {\"left_arm\": false}";
  for (const auto& [name, on] : torque.items()) {
    const auto found = std::ranges::find(kChainNames, name);
    if (found == kChainNames.end()) return "unknown limb; use one of " + text::joined(kChainNames, ", ");
    if (!on.is_boolean()) return "torque must be true (on) or false (off)";
    requests.torque[static_cast<std::size_t>(found - kChainNames.begin())] = on.get<bool>();
  }
  return {};
}

}  // namespace

std::string_view limbName(std::size_t limb) {
  return kChainNames.at(limb);
}

std::optional<SteeringMessage> parseSteering(std::string_view text, std::string& why) {
  const Json message = Json::parse(text.begin(), text.end(), nullptr, false);
  why = "the request must be a JSON object";
  if (!message.is_object()) return std::nullopt;
  SteeringMessage request;
  for (const auto& [name, flag] :
       {std::pair{"take", &request.take}, std::pair{"stop", &request.stop}, std::pair{"leave", &request.leave}}) {
    const auto found = message.find(name);
    if (found == message.end()) continue;
    why = std::string{"\""} + name + "\" must be true or false";
    if (!found->is_boolean()) return std::nullopt;
    *flag = found->get<bool>();
  }
  for (const auto& [name, read] : {std::pair{"goals", &takeGoals}, std::pair{"walk", &takeWalk},
                                   std::pair{"page", &takePage}, std::pair{"torque", &takeTorque}}) {
    why = message.contains(name) ? read(message[name], request.requests) : "";
    if (!why.empty()) return std::nullopt;
  }
  return request;
}

}  // namespace darwinop::window
