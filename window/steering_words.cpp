#include "window/steering_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace darwinop::window {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, kLimbs> kLimbNames{"right_arm", "left_arm", "head", "right_leg", "left_leg"};
constexpr int kLastPage = 255;

std::optional<Joint> jointOfName(const std::string& name) {
  for (std::size_t i = 0; i < kJoints; ++i)
    if (kJointTable[i].name == name) return static_cast<Joint>(i);
  return std::nullopt;
}

/// Empty: all of them are goals.
std::string takeGoals(const Json& goals, Orders& orders) {
  if (!goals.is_object()) return "\"goals\" has to be an object: {\"Neck\": 0.3}";
  for (const auto& [name, angle] : goals.items()) {
    const std::optional<Joint> joint = jointOfName(name);
    if (!joint) return "there is no joint of that name; \"hello\" of the monitor lists them";
    if (!angle.is_number() || !std::isfinite(angle.get<double>())) return "a goal has to be a number, in rad";
    orders.goals[index(*joint)] = Rad{angle.get<double>()};
  }
  return {};
}

std::string takeWalk(const Json& walk, Orders& orders) {
  gait::WalkCommand wish;
  if (!walk.is_object()) return "\"walk\" has to be an object: {\"x\": 0.5}";
  for (const auto& [name, amplitude] : walk.items()) {
    double* const field = name == "x" ? &wish.x : name == "y" ? &wish.y : name == "a" ? &wish.a : nullptr;
    if (field == nullptr) return "\"walk\" knows x (forwards), y (left) and a (turn to the left)";
    if (!amplitude.is_number() || !std::isfinite(amplitude.get<double>())) return "an amplitude has to be a number";
    *field = std::clamp(amplitude.get<double>(), -1.0, 1.0);
  }
  orders.walk = wish;
  return {};
}

std::string takePage(const Json& page, Orders& orders) {
  if (!page.is_number_integer() || page.get<std::int64_t>() < 1 || page.get<std::int64_t>() > kLastPage)
    return "\"page\" has to be a number from 1 to 255";
  orders.page = page.get<int>();
  return {};
}

std::string takeTorque(const Json& torque, Orders& orders) {
  if (!torque.is_object()) return "\"torque\" has to be an object: {\"left_arm\": false}";
  for (const auto& [name, on] : torque.items()) {
    const auto found = std::ranges::find(kLimbNames, name);
    if (found == kLimbNames.end()) return "limbs are right_arm, left_arm, head, right_leg and left_leg";
    if (!on.is_boolean()) return "torque is on, true, or off, false";
    orders.torque[static_cast<std::size_t>(found - kLimbNames.begin())] = on.get<bool>();
  }
  return {};
}

}  // namespace

std::string_view limbName(std::size_t limb) {
  return kLimbNames.at(limb);
}

std::optional<SteeringWords> readSteering(std::string_view text, std::string& why) {
  const Json said = Json::parse(text.begin(), text.end(), nullptr, false);
  why = "that is no JSON object";
  if (!said.is_object()) return std::nullopt;
  SteeringWords words;
  for (const auto& [name, flag] :
       {std::pair{"take", &words.take}, std::pair{"stop", &words.stop}, std::pair{"leave", &words.leave}}) {
    const auto found = said.find(name);
    if (found == said.end()) continue;
    why = std::string{"\""} + name + "\" has to be true or false";
    if (!found->is_boolean()) return std::nullopt;
    *flag = found->get<bool>();
  }
  for (const auto& [name, read] : {std::pair{"goals", &takeGoals}, std::pair{"walk", &takeWalk},
                                   std::pair{"page", &takePage}, std::pair{"torque", &takeTorque}}) {
    why = said.contains(name) ? read(said[name], words.orders) : "";
    if (!why.empty()) return std::nullopt;
  }
  return words;
}

}  // namespace darwinop::window
