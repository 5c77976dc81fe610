#include "connect/robot_file.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <vector>

#include "connect/imu_keys.hpp"
#include "connect/messages.hpp"
#include "core/board_models.hpp"
#include "core/servo_models.hpp"
#include "core/text/ini_text.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"
#include "hal/text_file.hpp"
#include "safety/layers.hpp"
#include "safety/sections.hpp"

namespace darwinop::connect {
namespace {

using text::lowered;

constexpr const char* kSections = "there are [Robot], [Safety], [Limits], [Offsets] and [Imu]";

[[noreturn]] void refuse(std::string_view section, std::string_view key, std::string_view value,
                         const std::string& allowed) {
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
  if (!ms || *ms < 8 || *ms > 1000 || *ms != std::floor(*ms))
    refuse("Robot", key, value, "give a whole number of ms from 8 to 1000 (16, or 8 when only goals are sent)");
  return std::chrono::milliseconds{static_cast<int>(*ms)};
}

std::uint16_t modelNumber(std::string_view key, std::string_view value) {
  const auto number = text::numberFromText(value);
  if (!number || *number < 0 || *number > 0xFFFF || *number != std::floor(*number))
    refuse("Robot", key, value, "give the model number that `darwinop doctor` prints, 0 to 65535");
  return static_cast<std::uint16_t>(*number);
}

/// True for "none": servos alone on an adapter.
bool permitsNoBoard(std::string_view key, std::string_view value) {
  if (lowered(value) != kNoBoard.name)
    refuse(
        "Robot", key, value,
        "give none for servos on a USB2Dynamixel or U2D2 (no buttons, no inertial sensor); without this key a CM-730 "
        "or CM-740 has to answer");
  return true;
}

/// The items of "A, B" without blanks; an empty one where one is missing. Nothing: none.
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

/// "Neck, Head"; nothing: none.
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

std::string permittableModels() {
  std::string names;
  for (const ServoModel& model : kServoModels)
    if (model.use == ServoUse::kIfPermitted) names.append(names.empty() ? "" : ", ").append(model.name);
  return names;
}

/// "MX-64, MX-106"; nothing: none.
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

std::string atAngle(double rad) {
  char text[32];
  std::snprintf(text, sizeof text, "%+.4f", rad);
  return text;
}

/// Strict, unlike config.ini: there are no old files to support.
class Reader final : public text::IniReader {
 public:
  explicit Reader(const std::string& path) { file_.path = path; }

  RobotFile take(std::string_view text) {
    text::readIni(text, file_.path, *this);
    safety::checkSafety(file_.safety, file_.path);
    return file_;
  }

 private:
  void section(std::string_view name, int) override {
    const std::string room = lowered(name);
    if (room != "robot" && room != "safety" && room != "limits" && room != "offsets" && room != "imu")
      throw std::runtime_error("there is no section [" + std::string{name} + "]; " + kSections);
  }

  void stray(std::string_view, std::string_view text, int) override {
    throw std::runtime_error("\"" + std::string{text} + "\" is no [section], no key = value and no comment");
  }

  void pair(std::string_view section, std::string_view key, std::string_view value, int) override {
    if (section.empty())
      throw std::runtime_error("key \"" + std::string{key} + "\" stands before the first section; " + kSections);
    const std::string room = lowered(section);
    if (!seen_.insert(room + '/' + lowered(key)).second)
      throw std::runtime_error("[" + std::string{section} + "] " + std::string{key} + messages::kGivenTwice);
    if (safety::takeSafety(file_.safety, section, key, value)) return;
    if (room == "offsets") return takeOffset(key, value);
    if (room == "imu") return takeImu(key, value);
    takeRobot(key, value);
  }

  void takeRobot(std::string_view key, std::string_view value) {
    const std::string name = lowered(key);
    if (name == "port")
      file_.port = device(key, value, kRobotsPort);
    else if (name == "camera")
      file_.camera = device(key, value, "/dev/video0");
    else if (name == "period_ms")
      file_.period = periodInMs(key, value);
    else if (name == "group")
      file_.group = accountName(key, value, "group of users");
    else if (name == "controller_user")
      file_.controller_user = accountName(key, value, "user");
    else if (name == "absent")
      file_.safety.absent = jointNames(key, value);
    else if (name == "board_model")
      file_.permitted.board_model = modelNumber(key, value);
    else if (name == "board")
      file_.permitted.no_board = permitsNoBoard(key, value);
    else if (name == "servo_models")
      file_.permitted.servo_models = servoModels(key, value);
    else
      refuse("Robot", key, value,
             "no such key; there are port, camera, period_ms, group, controller_user, absent, board, board_model "
             "and servo_models");
  }

  void takeOffset(std::string_view key, std::string_view value) {
    const auto joint = findJoint(jointName(key));
    if (!joint) refuse("Offsets", key, value, safety::kNoSuchJoint);
    const auto offset = text::numberFromText(value);
    if (!offset || !(std::abs(*offset) <= kMostOffset))
      refuse("Offsets", key, value,
             "give a number from -0.2 to 0.2 rad; a horn that is further off has to be remounted");
    file_.offsets.set(*joint, Rad{*offset});
  }

  void takeImu(std::string_view key, std::string_view value) {
    const auto* const row = std::ranges::find(kImuKeys, lowered(key), &ImuKey::name);
    if (row == kImuKeys.end()) refuse("Imu", key, value, messages::kNoSuchImuKey);
    const std::vector<std::string_view> numbers = listed(value);
    const auto refuseNumbers = [&] {
      refuse("Imu", key, value,
             "give three numbers from " + text::shortestText(row->low) + " to " + text::shortestText(row->high) +
                 (row->unit.empty() ? "" : " " + std::string{row->unit}) + ", with commas between");
    };
    if (numbers.size() != 3) refuseNumbers();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = text::numberFromText(numbers[i]);
      if (!number || *number < row->low || *number > row->high) refuseNumbers();
      (file_.imu.*(row->axes))[i] = *number;
    }
  }

  RobotFile file_;
  std::set<std::string> seen_;  // "section/key", in lower case
};

}  // namespace

RobotFile parseRobotFile(std::string_view text, const std::string& path) {
  return Reader{path}.take(text);
}

std::string robotFilePath(const std::string& usual) {
  const char* const named = std::getenv("DARWINOP_ROBOT_FILE");
  return named != nullptr && *named != '\0' ? named : usual;
}

RobotFile readRobotFile(const std::string& usual) {
  const std::string path = robotFilePath(usual);
  const auto text = readTextFile(path);
  if (!text && path != usual)
    throw std::runtime_error("DARWINOP_ROBOT_FILE names " + path +
                             ", and there is no such file; correct the path or unset the variable");
  return text ? parseRobotFile(*text, path) : RobotFile{};
}

safety::Config safetyOn(const RobotFile& robot, const safety::Config& controller, const std::string& controller_file) {
  if (robot.path.empty()) return controller;
  safety::Config config = safety::layered({robot.safety, robot.path}, {controller, controller_file});
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    safety::JointRange& range = config.range[i];
    range = {std::max(range.low, robot.offsets.low(joint)), std::min(range.high, robot.offsets.high(joint))};
    if (range.low >= range.high)
      throw std::runtime_error(robot.path + ", [Offsets] " + std::string{kJointTable[i].name} +
                               ": the offset leaves nothing of the range that [Limits] of this file and of " +
                               controller_file + " allow; widen the limits");
  }
  return config;
}

std::string describe(const RobotFile& robot) {
  if (robot.path.empty()) return messages::kNoRobotFile;
  std::string text = robot.path + ": port " + robot.serialPort() + ", " +
                     std::to_string(robot.period.value_or(kUsualPeriod) / std::chrono::milliseconds{1}) + " ms";
  std::string offsets, limits, absent, models;
  for (std::size_t i = 0; i < kServoModels.size(); ++i)
    if (robot.permitted.servo_models[i]) models.append(" ").append(kServoModels[i].name);
  const safety::Config stock;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::string name{kJointTable[i].name};
    if (robot.safety.absent[i]) absent += " " + name;
    const int ticks = robot.offsets.ticks(static_cast<Joint>(i));
    if (ticks != 0) offsets += " " + name + " " + atAngle(ticks * kRadPerTick);
    const safety::JointRange& range = robot.safety.range[i];
    if (range.low != stock.range[i].low || range.high != stock.range[i].high) limits += " " + name;
  }
  const std::size_t named = robot.safety.named.count();
  if (named > 0) text += ", " + std::to_string(named) + (named == 1 ? " setting" : " settings") + " of [Safety]";
  if (robot.permitted.board_model != RobotFile{}.permitted.board_model)
    text += ", board model " + std::to_string(robot.permitted.board_model);
  if (robot.permitted.no_board) text += messages::kHasNoBoard;
  if (!models.empty()) text += ", servo models:" + models;
  if (!absent.empty()) text += ", absent:" + absent;
  if (!limits.empty()) text += ", narrowed:" + limits;
  if (!offsets.empty()) text += ", offsets in rad:" + offsets;
  if (robot.imu != cm730::ImuCalibration{}) text += messages::kImuIsCalibrated;
  return text;
}

}  // namespace darwinop::connect
