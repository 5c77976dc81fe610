// robot.ini in one line.
#include <chrono>
#include <cstdio>

#include "connect/messages.hpp"
#include "connect/robot_file.hpp"
#include "core/servo_models.hpp"

namespace darwinop::connect {
namespace {

std::string atAngle(double rad) {
  char text[32];
  std::snprintf(text, sizeof text, "%+.4f", rad);
  return text;
}

}  // namespace

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
