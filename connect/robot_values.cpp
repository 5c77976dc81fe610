#include "connect/robot_values.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "connect/messages.hpp"
#include "connect/serial_bus.hpp"
#include "core/board_models.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"

namespace darwinop::connect {
namespace {

using text::lowered;

std::string permittableModels() {
  std::string names;
  for (const ServoModel& model : kServoModels)
    if (model.use == ServoUse::kIfPermitted) names.append(names.empty() ? "" : ", ").append(model.name);
  return names;
}

}  // namespace

void refuse(std::string_view section, std::string_view key, std::string_view value, const std::string& allowed) {
  throw std::runtime_error("[" + std::string{section} + "] " + std::string{key} + " = " + std::string{value} + ": " +
                           allowed);
}

std::string device(std::string_view key, std::string_view value, const char* example) {
  if (value.size() < 2 || !value.starts_with('/') || value.find_first_of(" \t") != value.npos)
    refuse("Robot", key, value, std::string{"give the path of a device, for example "} + example);
  return std::string{value};
}

std::string accountName(std::string_view key, std::string_view value, const char* what) {
  if (value.find_first_of(" \t:,/") != value.npos)
    refuse("Robot", key, value, std::string{"give the name of one "} + what + ", or nothing");
  return std::string{value};
}

Nanos periodInMs(std::string_view key, std::string_view value) {
  const auto ms = text::numberFromText(value);
  if (!ms || *ms < kShortestPeriod.count() || *ms > kLongestPeriod.count() || *ms != std::floor(*ms))
    refuse("Robot", key, value,
           "give a whole number of ms from " + std::to_string(kShortestPeriod.count()) + " to " +
               std::to_string(kLongestPeriod.count()) + " (16, or 8 when only goals are sent)");
  return std::chrono::milliseconds{static_cast<int>(*ms)};
}

std::uint16_t modelNumber(std::string_view key, std::string_view value) {
  const auto number = text::numberFromText(value);
  if (!number || *number < 0 || *number > 0xFFFF || *number != std::floor(*number))
    refuse("Robot", key, value, "give the model number that `darwinop doctor` prints, 0 to 65535");
  return static_cast<std::uint16_t>(*number);
}

bool permitsNoBoard(std::string_view key, std::string_view value) {
  if (lowered(value) != kNoBoard.name)
    refuse(
        "Robot", key, value,
        "give none for servos on a USB2Dynamixel or U2D2 (no buttons, no inertial sensor); without this key a CM-730 "
        "or CM-740 has to answer");
  return true;
}

std::vector<std::string_view> listed(std::string_view value) {
  std::vector<std::string_view> items;
  if (text::withoutBlanks(value).empty()) return items;
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t comma = std::min(value.find(',', begin), value.size());
    items.push_back(text::withoutBlanks(value.substr(begin, comma - begin)));
    begin = comma + 1;
  }
  return items;
}

std::bitset<kJoints> jointNames(std::string_view key, std::string_view value) {
  std::bitset<kJoints> joints;
  for (const std::string_view name : listed(value)) {
    const auto joint = findJoint(jointName(name));
    if (!joint)
      refuse("Robot", key, value, "give names of joints as in Webots with commas between, e.g. Neck, Head; or nothing");
    joints.set(index(*joint));
  }
  if (joints.all()) refuse("Robot", key, value, messages::kNoJointLeft);
  return joints;
}

ServoModels servoModels(std::string_view key, std::string_view value) {
  ServoModels models;
  for (const std::string_view name : listed(value)) {
    const auto* const model = std::ranges::find_if(kServoModels, [name](const ServoModel& row) {
      return row.use == ServoUse::kIfPermitted && lowered(row.name) == lowered(name);
    });
    if (model == kServoModels.end()) refuse("Robot", key, value, messages::kNoSuchServoModel + permittableModels());
    models.set(static_cast<std::size_t>(model - kServoModels.begin()));
  }
  return models;
}

}  // namespace darwinop::connect
