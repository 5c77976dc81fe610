#include "window/steering_words.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace darwinop::window {
namespace {

using Json = nlohmann::json;

std::optional<Joint> jointOfName(const std::string& name) {
  for (std::size_t i = 0; i < kJoints; ++i)
    if (kJointTable[i].name == name) return static_cast<Joint>(i);
  return std::nullopt;
}

/// Empty: all of them are goals.
std::string takeGoals(const Json& goals, SteeringWords& words) {
  if (!goals.is_object()) return "\"goals\" has to be an object: {\"Neck\": 0.3}";
  for (const auto& [name, angle] : goals.items()) {
    const std::optional<Joint> joint = jointOfName(name);
    if (!joint) return "there is no joint of that name; \"hello\" of the monitor lists them";
    if (!angle.is_number() || !std::isfinite(angle.get<double>())) return "a goal has to be a number, in rad";
    words.goals.emplace_back(*joint, Rad{angle.get<double>()});
  }
  return {};
}

}  // namespace

std::optional<SteeringWords> readSteering(std::string_view text, std::string& why) {
  const Json said = Json::parse(text.begin(), text.end(), nullptr, false);
  why = "that is no JSON object";
  if (!said.is_object()) return std::nullopt;
  SteeringWords words;
  for (const auto& [name, flag] : {std::pair{"take", &words.take}, std::pair{"stop", &words.stop}}) {
    const auto found = said.find(name);
    if (found == said.end()) continue;
    why = std::string{"\""} + name + "\" has to be true or false";
    if (!found->is_boolean()) return std::nullopt;
    *flag = found->get<bool>();
  }
  why = said.contains("goals") ? takeGoals(said["goals"], words) : "";
  if (!why.empty()) return std::nullopt;
  return words;
}

}  // namespace darwinop::window
