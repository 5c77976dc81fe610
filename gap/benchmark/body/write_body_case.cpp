#include "gap/benchmark/body/write_body_case.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gap/plant/body/limb_parts.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDecimals = 4;
constexpr std::size_t kSlowRows = 60;  // rows between readings of voltage and temperature

/// Four decimals, trailing zeros left out; NaN: nothing.
void append(std::string& line, double value) {
  line += ',';
  if (std::isnan(value)) return;
  char digits[40];
  const double rounded = std::round(value * 1e4) / 1e4;
  const auto end =
      std::to_chars(digits, digits + sizeof digits, rounded == 0 ? 0 : rounded, std::chars_format::fixed, kDecimals);
  std::string text(digits, end.ptr);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  line += text;
}

std::string recordingOf(const BodyCase& given, std::size_t index) {
  const BodyLog& log = given.logs[index];
  std::string text = "time_s,cycle";
  for (const char* sensor : {"gyro", "accelerometer"})
    for (const char* axis : {".x", ".y", ".z"})
      text += std::string{","} + sensor + axis + (*sensor == 'g' ? " [rad/s]" : " [m/s2]");
  text += ",board.voltage [V]";
  for (const JointRow& joint : kJointTable)
    for (const char* column :
         {".asked_p_gain", ".commanded [rad]", ".position [rad]", ".load", ".voltage [V]", ".temperature [degC]"})
      text += "," + std::string{joint.name} + column;
  text += "\n";
  constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t row = 0; row < log.rows(); ++row) {
    std::string line;
    append(line, log.time_s[row]);
    line.erase(0, 1);
    line += "," + std::to_string(row + 1);
    for (const AxesColumns* sensor : {&log.gyro_rad_s, &log.accel_m_s2})
      for (const std::vector<double>& axis : *sensor) append(line, axis[row]);
    append(line, log.board_v[row]);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      const Trajectory& of = given.joint(index, joint);
      append(line, of.pRegisterAt(row) / kPRegisterPerKp);
      append(line, of.torque_on[row] != 0 ? of.goal_rad[row] : kNotRead);
      append(line, of.position_rad[row]);
      append(line, of.load[row]);
      const bool is_polled = (row + 3 * joint) % kSlowRows == 0;
      append(line, is_polled ? of.volt_v[row] : kNotRead);
      append(line, is_polled ? of.temp_c[row] : kNotRead);
    }
    text += line + "\n";
  }
  return text;
}

Json jsonOf(const BodyCase& given) {
  Json trust = Json::object(), logs = Json::array();
  if (given.trust.empty()) trust["exact"] = true;
  for (const auto& [key, sigma] : given.trust) trust[key] = sigma;
  for (const BodyLog& log : given.logs) {
    Json one{{"file", log.file}, {"role", log.held_out ? "score" : "fit"}, {"setup", name(log.setup)}};
    if (log.up) one["up"] = *log.up;
    if (!log.lies_on.empty()) one["up"] = log.lies_on;
    one["session_s"] = log.session_start_s;
    one["repeat_of"] = log.repeat_of ? Json(given.logs[*log.repeat_of].file) : Json(nullptr);
    one["battery_V"] = log.battery_v;
    logs.push_back(std::move(one));
  }
  return {{"case", given.name}, {"family", "body"}, {"model", given.model}, {"trust", trust}, {"logs", logs}};
}

}  // namespace

void writeBodyCase(const BodyCase& given, const std::string& folder) {
  const std::filesystem::path path{folder};
  std::filesystem::create_directories(path);
  writeTextFile(path / "case.json", jsonOf(given).dump(1) + "\n");
  for (std::size_t i = 0; i < given.logs.size(); ++i) writeTextFile(path / given.logs[i].file, recordingOf(given, i));
}

}  // namespace darwinop::gap
