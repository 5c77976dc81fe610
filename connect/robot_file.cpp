#include "connect/robot_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "connect/imu_keys.hpp"
#include "connect/messages.hpp"
#include "connect/robot_values.hpp"
#include "core/text/ini_text.hpp"
#include "core/text/key_lines.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"
#include "hal/text_file.hpp"
#include "safety/layers.hpp"
#include "safety/sections.hpp"

namespace darwinop::connect {
namespace {

using text::lowered;

constexpr const char* kSections = "there are [Robot], [Safety], [Limits], [Offsets] and [Imu]";

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

  void pair(std::string_view section, std::string_view key, std::string_view value, int line) override {
    if (section.empty())
      throw std::runtime_error("key \"" + std::string{key} + "\" stands before the first section; " + kSections);
    const std::string room = lowered(section);
    if (keys_.firstOf(section, key, line) > 0)
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
  text::KeyLines keys_;
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

}  // namespace darwinop::connect
