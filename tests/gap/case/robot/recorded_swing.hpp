// A recording of an arm that swings, and a folder for it.
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "twin/body/robot_body.hpp"

namespace darwinop::gap {

inline constexpr double kRowTime = 0.016;
inline constexpr double kSwings = 3;  // s; the shoulder holds 0 until then
inline constexpr std::array<double, 3> kUpright{0, 0, 9.81};

inline std::string nameOf(std::size_t joint) {
  return std::string{kJointTable[joint].name};
}

/// What the runtime would have recorded of the twin: the right arm is stretched, swings at the shoulder, and goes limp.
/// `began_s`: of the recording's clock. `silent`: a joint that is neither driven nor answers. `profile`: a speed limit
/// that is far away, asked for until the shoulder swings.
inline std::string recordedSwing(double began_s = 0, std::optional<Joint> silent = {},
                                 const std::string& profile = "") {
  twin::RobotBody body{twin::readModel(twin::findModel("darwin-op"))};
  Drives drives;
  for (std::size_t i = 0; i < kJoints; ++i)
    drives[i] = {.torque_on = true,
                 .goal_rad = body.state().joint[i].position_rad,
                 .speed_limit_rad_s = std::numeric_limits<double>::infinity(),
                 .torque_limit = 1,
                 .supply_v = 11.8};
  std::string text =
      "# darwinop log, format 1\n# robot: darwin-op\n# experiment: swing\ntime_s,cycle,board.voltage [V]";
  for (const char axis : {'x', 'y', 'z'}) text += std::string{",accelerometer."} + axis + " [m/s2]";
  for (std::size_t i = 0; i < kJoints; ++i)
    text += "," + nameOf(i) + ".commanded [rad]," + nameOf(i) + ".position [rad]";
  text +=
      ",ShoulderR.asked_p_gain,ShoulderR.asked_speed [rad/s],ShoulderR.velocity [rad/s],ShoulderR.load,"
      "ShoulderR.voltage [V],ShoulderR.temperature [degC]\n";

  ServoDrive& shoulder = drives[index(Joint::kShoulderR)];
  const auto number = [](double value) { return "," + std::to_string(value); };
  for (int cycle = 1; cycle * kRowTime < 8; ++cycle) {
    const double t = cycle * kRowTime;
    const BodyState& state = body.state();
    text += std::to_string(began_s + t) + "," + std::to_string(cycle) + ",11.8";
    for (const double accel : state.accel_m_s2) text += number(accel);
    const double share = std::min(t / 1.5, 1.0);  // to the pose
    drives[index(Joint::kArmUpperR)].goal_rad = share * -0.65;
    drives[index(Joint::kArmLowerR)].goal_rad = share * -1.55;
    if (t < 1.5) shoulder.goal_rad *= 1 - kRowTime / (1.5 - t + kRowTime);
    if (t > kSwings) shoulder.goal_rad = t < 3.8 ? 0.7 : t < 4.6 ? -0.3 : 0.9;
    shoulder.torque_on = t < 5.5;
    for (std::size_t i = 0; i < kJoints; ++i)
      text += static_cast<Joint>(i) == silent
                  ? ",,"
                  : (drives[i].torque_on ? number(drives[i].goal_rad) : ",") + number(state.joint[i].position_rad);
    const JointMotion& reading = state.joint[index(Joint::kShoulderR)];
    text += ",4," + (t > kSwings ? "" : profile) + "," + std::to_string(reading.velocity_rad_s) + number(reading.load) +
            ",,30\n";
    for (int ms = 0; ms < 16; ++ms) body.step(std::chrono::milliseconds{1}, drives);
  }
  return text + "# end\n";
}

/// `recording` with these readings of the accelerometer in each row: "1,0,9.7".
inline std::string withAccelerometer(const std::string& recording, const std::string& readings) {
  std::istringstream lines{recording};
  std::string text;
  for (std::string line; std::getline(lines, line); text += line + "\n") {
    if (std::isdigit(line.front()) == 0) continue;
    std::size_t from = 0;
    for (int column = 0; column < 3; ++column) from = line.find(',', from) + 1;
    std::size_t to = from;
    for (int axis = 0; axis < 3; ++axis) to = line.find(',', to) + 1;
    line.replace(from, to - 1 - from, readings);
  }
  return text;
}

class Folder : public testing::Test {
 protected:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "darwinop-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Folder() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};
}  // namespace darwinop::gap
