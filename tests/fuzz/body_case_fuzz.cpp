// A case of the whole robot: case.json and, after a byte 0, one row of each recording. An error message, or a valid
// case whose data check has a text.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include "experiments/logs/read_log.hpp"
#include "gap/case/body/body_check.hpp"
#include "gap/case/body/parse_body_case.hpp"

namespace {

using namespace darwinop;

constexpr std::size_t kRows = 24, kReplaced = 7;  // rows of a recording, and the one that the input writes

void require(bool holds) {
  if (!holds) std::abort();
}

/// A resting robot; each row holds x for time and cycle, then the same values.
std::string recording(std::string_view replaced) {
  std::string text = "time_s,cycle,gyro.x [rad/s],gyro.y [rad/s],gyro.z [rad/s],accelerometer.x [m/s2]," +
                     std::string{"accelerometer.y [m/s2],accelerometer.z [m/s2],board.voltage [V]"};
  std::string values = ",0.01,0,0,0,9.8,0,11.8";
  for (const JointRow& joint : kJointTable) {
    const std::string name{joint.name};
    text += "," + name + ".commanded [rad]," + name + ".asked_p_gain," + name + ".position [rad]," + name + ".load";
    values += ",0.1,4,0.1,0.02";
  }
  for (std::size_t row = 0; row < kRows; ++row) {
    text += '\n';
    if (row == kReplaced && !replaced.empty())
      text += replaced;
    else
      text += std::to_string(0.016 * static_cast<double>(row)) + "," + std::to_string(row) + values;
  }
  return text + "\n";
}

twin::Model anyModel(const std::string&) {
  return twin::parseModel("[model]\nname = any\n", "any.ini");
}

void requireSane(const gap::BodyCase& c) {
  require(!c.logs.empty() && c.joints.logs.size() == c.logs.size() * kJoints);
  for (const auto& [key, sigma] : c.trust) require(sigma > 0 && std::isfinite(sigma));
  for (const gap::BodyLog& log : c.logs) {
    require(log.rows() > 1 && log.board_v.size() == log.rows());
    require(log.battery_v > 0 && (!log.repeat_of || *log.repeat_of < c.logs.size()));
    require(!log.up || std::abs(std::hypot((*log.up)[0], (*log.up)[1], (*log.up)[2]) - 1) < 1e-9);
  }
  for (const gap::Trajectory& joint : c.joints.logs)
    require(joint.position_rad.size() == joint.rows() && joint.p_register_of_row.size() == joint.rows());
  require(!asText(c, checkData(c)).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view all{reinterpret_cast<const char*>(data), size};
  const std::size_t end = std::min(all.find('\0'), size);
  const std::string_view json = all.substr(0, end), row = end < size ? all.substr(end + 1) : std::string_view{};
  const auto log = [&](const std::string& name) { return logs::parseLog(recording(row), name); };
  try {
    requireSane(gap::parseBodyCase(json, "my/case.json", {.log = log, .model = anyModel}));
  } catch (const gap::BadInput& refused) {
    require(std::string_view{refused.what()}.find(": ") != std::string_view::npos);
  }
  return 0;
}
