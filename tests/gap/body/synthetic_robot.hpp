// A robot whose recordings a test writes itself: servos that follow their goals late, a clamped trunk, and a sensor
// with whatever deviation the test gives it. Nothing here is of the code under test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/joints.hpp"
#include "core/random.hpp"
#include "core/units.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/case/body/parse_body_case.hpp"
#include "support/replaced.hpp"

namespace darwinop::gap {

using Vector = std::array<double, 3>;

/// Rounded to a step.
inline double inSteps(double value, double step) {
  return std::nearbyint(value / step) * step;
}

struct SyntheticRobot {
  Vector gyro_bias{}, accel_bias{}, accel_scale{1, 1, 1};
  std::function<Vector(const Vector& reading)> map = [](const Vector& reading) { return reading; };
  double yaw_rad = 0;  // of the sensor's board about the trunk's forward axis
  /// Duty of a joint by the error of its position, in place of the law.
  std::function<double(std::size_t joint, double duty)> duty = [](std::size_t, double of_law) { return of_law; };
  double servo_sag_v = 0;  // of joint 3
  double p_gain_late = 4;  // Kp from the middle of a recording on
  std::size_t limp_joint = kJoints, limp_from = 60, limp_to = 100;
  std::size_t absent_joint = kJoints;  // has no servo
  bool commands_absent_joint = false;
  bool falls = false;
  std::uint64_t seed = 1;
  std::string trust = R"({"exact": true})";

  /// What the sensor reads where the trunk's frame (left, up, forward) has this direction of up.
  [[nodiscard]] Vector accelerometer(const Vector& up) const {
    // The board's left axis is turned towards up.
    const double left = std::cos(yaw_rad) * up[0] + std::sin(yaw_rad) * up[1];
    const double top = -std::sin(yaw_rad) * up[0] + std::cos(yaw_rad) * up[1];
    Vector reading = map({-9.81 * left, 9.81 * up[2], 9.81 * top});  // right, forward, up
    for (std::size_t i = 0; i < 3; ++i) reading[i] = reading[i] * accel_scale[i] + accel_bias[i];
    return reading;
  }

  [[nodiscard]] std::string recording(const Vector& up, std::uint64_t of) const {
    std::string text = "time_s,cycle";
    for (const char* sensor : {"gyro", "accelerometer"})
      for (const char* axis : {".x", ".y", ".z"})
        text += std::string{","} + sensor + axis + (*sensor == 'g' ? " [rad/s]" : " [m/s2]");
    text += ",board.voltage [V]";
    for (const JointRow& joint : kJointTable)
      for (const char* column : {".asked_p_gain", ".commanded [rad]", ".position [rad]", ".load", ".voltage [V]"})
        text += "," + std::string{joint.name} + column;
    text += "\n";
    Rng rng{seed * 1000 + of};
    constexpr double kTick = 2 * kPi / 4096;
    constexpr int kRowsOfLog = 160;
    for (int row = 0; row < kRowsOfLog; ++row) {
      text += std::to_string(0.016 * row) + "," + std::to_string(row + 1);
      for (std::size_t i = 0; i < 3; ++i)
        text += "," + std::to_string(inSteps(gyro_bias[i] + 0.03 * rng.normal(), 0.0545));
      const Vector still = accelerometer(falls && row > 80 ? Vector{up[1], up[2], up[0]} : up);
      for (std::size_t i = 0; i < 3; ++i) text += "," + std::to_string(inSteps(still[i] + 0.04 * rng.normal(), 0.0766));
      text += ",11.8";
      for (std::size_t j = 0; j < kJoints; ++j) {
        if (j == absent_joint) {
          text += commands_absent_joint ? ",,0.1,,," : ",,,,,";
          continue;
        }
        const auto goal = [&](int k) { return 0.3 * std::sin(0.05 * k + static_cast<double>(j)); };
        const auto gain = [&](int k) { return k < kRowsOfLog / 2 ? 4 : p_gain_late; };
        const auto limp = [&](int k) {
          return j == limp_joint && k >= static_cast<int>(limp_from) && k < static_cast<int>(limp_to);
        };
        const double position = inSteps(goal(row - 3), kTick);
        const double law = std::clamp(0.158 * 8 * gain(row - 1) * (inSteps(goal(row - 1), kTick) - position), -1., 1.);
        const double load = limp(row - 1) || row == 0 ? 0 : duty(j, law);
        text += "," + std::to_string(gain(row)) + ",";
        if (!limp(row)) text += std::to_string(inSteps(goal(row), kTick));
        text += "," + std::to_string(position) + "," + std::to_string(inSteps(load, 1. / 1023)) + ",";
        const double volt_v = 11.8 - (j == 3 ? servo_sag_v : 0) + 0.03 * rng.normal();
        if (row % 8 == 0) text += std::to_string(inSteps(volt_v, 0.1));
      }
      text += "\n";
    }
    return text;
  }
};

/// A valid case of the whole robot in memory, which a test may break.
struct BodyTexts {
  explicit BodyTexts(const SyntheticRobot& robot = {}) {
    json = R"({"case": "robot", "family": "body", "model": "darwin-op", "trust": )" + robot.trust + R"(, "logs": [
  {"file": "up.csv", "role": "fit", "setup": "stand_clamped", "up": [0, 1, 0], "session_s": 3, "battery_V": 11.8},
  {"file": "again.csv", "role": "fit", "setup": "stand_clamped", "up": [0, 1, 0], "repeat_of": "up.csv", "battery_V": 11.8},
  {"file": "side.csv", "role": "fit", "setup": "stand_clamped", "up": [-1, 0, 0], "battery_V": 11.8},
  {"file": "face.csv", "role": "fit", "setup": "stand_clamped", "up": [0, 0, 1], "battery_V": 11.8},
  {"file": "floor.csv", "role": "fit", "setup": "floor", "battery_V": 11.8},
  {"file": "tilt.csv", "role": "score", "setup": "stand_clamped", "up": [0.48, 0.6, 0.64], "battery_V": 11.8}]})";
    const std::vector<std::pair<std::string, Vector>> ups{{"up.csv", {0, 1, 0}},    {"again.csv", {0, 1, 0}},
                                                          {"side.csv", {-1, 0, 0}}, {"face.csv", {0, 0, 1}},
                                                          {"floor.csv", {0, 1, 0}}, {"tilt.csv", {0.48, 0.6, 0.64}}};
    for (std::size_t i = 0; i < ups.size(); ++i) logs[ups[i].first] = robot.recording(ups[i].second, i);
  }

  std::string json;
  std::map<std::string, std::string> logs;

  [[nodiscard]] BodyCase read() const {
    return parseBodyCase(json, "my/case.json",
                         {.log =
                              [&](const std::string& name) {
                                const auto found = logs.find(name);
                                if (found == logs.end())
                                  throw std::runtime_error("my/" + name + ": there is no such file");
                                return logs::parseLog(found->second, "my/" + name);
                              },
                          .model = [](const std::string& name) { return twin::readModel(twin::findModel(name)); }});
  }
  /// What it is refused with; empty: it is read.
  [[nodiscard]] std::string error() const {
    try {
      (void)read();
    } catch (const BadInput& refused) {
      return refused.what();
    }
    return "";
  }
  [[nodiscard]] BodyTexts with(const std::string& what, const std::string& by) const {
    BodyTexts changed = *this;
    changed.json = replaced(json, what, by);
    return changed;
  }
  [[nodiscard]] BodyTexts withLog(const std::string& log, const std::string& what, const std::string& by) const {
    BodyTexts changed = *this;
    changed.logs[log] = replaced(logs.at(log), what, by);
    return changed;
  }
};

}  // namespace darwinop::gap
