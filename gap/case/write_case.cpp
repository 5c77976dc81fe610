// Case to files.
#include "gap/case/write_case.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "gap/case/baseline_keys.hpp"
#include "gap/case/fields.hpp"
#include "gap/case/parts.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr int kDigits = 9;

struct CsvColumn {
  std::string_view name;
  const std::vector<double> Trajectory::*values;
  double factor;  // from SI to the column's unit
};
constexpr CsvColumn kColumns[] = {
    {"pos_rad", &Trajectory::position_rad, 1}, {"speed_rad_s", &Trajectory::speed_rad_s, 1},
    {"load_pct", &Trajectory::load, 100},      {"volt_V", &Trajectory::volt_v, 1},
    {"temp_C", &Trajectory::temp_c, 1},        {"current_A", &Trajectory::current_a, 1},
    {"written_s", &Trajectory::written_s, 1},  {"read_s", &Trajectory::read_s, 1},
};

void append(std::string& line, double value) {
  if (std::isnan(value)) return;  // not known: an empty field
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, kDigits);
  line.append(text, end.ptr);
}

/// With every digit: nine of a Unix time are steps of 10 s.
void appendTime(std::string& line, double time_s) {
  char text[40];
  line.append(text, std::to_chars(text, text + sizeof text, time_s).ptr);
}

bool isKnown(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return !std::isnan(value); });
}

Json armOf(const Case& c) {
  Json arm = Json::object();
  for (const ArmKey& key : armKeys())
    if (key.member != nullptr) arm[std::string{key.json}] = c.pendulum.*key.member;
  return arm;
}

bool isVoltage(const Case& c) {
  return c.model.servo.law == twin::Law::kVoltageP;
}

/// What the reader takes for a number that `baseline` does not give.
double fallback(const Case& c, const ServoKey& key) {
  return c.datasheet ? c.datasheet->servo.*key.member : twin::ServoParameters{}.*key.member;
}

Json baselineOf(const Case& c) {
  const twin::ServoParameters& servo = c.model.servo;
  Json params = Json::object();
  for (const ServoKey& key : servoKeys())
    if ((isVoltage(c) ? key.of_voltage_p : key.of_speed_p) || servo.*key.member != fallback(c, key))
      params[std::string{key.json}] = servo.*key.member;
  for (const FrictionKey& key : frictionKeys()) {
    const auto found =
        std::ranges::find_if(c.model.effects, [&](const twin::EffectSetting& e) { return e.info == key.effect; });
    params[std::string{key.json}] = found == c.model.effects.end() ? 0.0 : found->values.front();
  }
  params.update(armOf(c));
  params["position_in_ticks"] = c.quantised;
  return {{"model", isVoltage(c) ? "voltage_p" : "speed_p"}, {"params", params}};
}

Json priorsOf(const Case& c) {
  Json priors = Json::object();
  for (const Prior& prior : c.priors) {
    std::string name = prior.number;
    for (const ServoKey& key : servoKeys())
      if (key.key == prior.number) name = key.json;
    for (const ArmKey& key : armKeys())
      if (key.prior == prior.number) name = key.json;
    for (const FrictionKey& key : frictionKeys())
      if (key.prior == prior.number) name = key.json;
    priors[name] = prior.relative_sigma;
  }
  return priors;
}

Json datasheetOf(const Datasheet& sheet) {
  Json out = Json::object();
  for (const ServoKey& key : servoKeys())
    if (isOfDatasheet(key)) out[std::string{key.json}] = sheet.servo.*key.member;
  out["rel_sigma"] = sheet.relative_sigma;
  return out;
}

Json entryOf(const Case& c, const Trajectory& log, const char* role) {
  Json entry = {{"file", log.file},
                {"role", role},
                {"trajectory", log.kind},
                {"kp", log.p_register},
                {"payload_kg", log.payload_kg},
                {"repeat_of", log.repeat_of ? Json(c.logs[*log.repeat_of].file) : Json(nullptr)}};
  for (const ArmKey& key : armKeys())
    if (key.of_log != nullptr && log.*key.of_log) entry[std::string{key.json}] = *(log.*key.of_log);
  if (log.is_session_known) entry["t0_session_s"] = log.session_start_s;
  if (log.supply_v) entry["supply_V"] = *log.supply_v;
  if (log.isReadAfterWrite() && log.is_phase_known) entry["firmware_in_step"] = true;
  if (log.goal_before_rad) entry["goal_before_rad"] = *log.goal_before_rad;
  if (log.speed_limit_rad_s > 0) entry["speed_limit_rad_s"] = log.speed_limit_rad_s;
  return entry;
}

Json logsOf(const Case& c) {
  Json list = Json::array();
  for (const Trajectory& log : c.logs) list.push_back(entryOf(c, log, log.held_out ? "held_out" : "fit"));
  for (const Trajectory& log : c.others) list.push_back(entryOf(c, log, log.held_out ? "other" : "validation"));
  return list;
}

}  // namespace

bool fitsBaseline(const Case& c) {
  const std::string text = caseAsJson(c, false);
  const Json json = parseJson(text, "case.json");
  Fields top{json, "case.json", ""};
  Case back;
  back.name = c.name;
  try {
    readModelPart(top, {}, std::nullopt, back);
    return twin::writeModel(back.model) == twin::writeModel(c.model);
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::string caseAsJson(const Case& c, bool with_model_file) {
  Json out = {{"case", c.name}, {"goal_order", c.goal_order == GoalOrder::kAfterRead ? "after_read" : "before_read"}};
  if (c.joint) out["joint"] = row(*c.joint).name;
  if (with_model_file) {
    out["model"] = "model.ini";
    out["arm"] = armOf(c);
    out["position_in_ticks"] = c.quantised;
  } else {
    out["baseline"] = baselineOf(c);
  }
  if (c.pendulum.gravity_m_s2 == 0) out["axis"] = "vertical";
  out["prior_rel_sigma"] = priorsOf(c);
  if (c.datasheet) out["servo_datasheet"] = datasheetOf(*c.datasheet);
  out["logs"] = logsOf(c);
  return out.dump(1) + "\n";
}

std::string logAsCsv(const Trajectory& log) {
  std::string text = "t_s,goal_rad,torque_on";
  for (const CsvColumn& column : kColumns)
    if (isKnown(log.*column.values)) text.append(",").append(column.name);
  text += '\n';
  for (std::size_t i = 0; i < log.rows(); ++i) {
    appendTime(text, log.time_s[i]);
    append(text += ',', log.goal_rad[i]);
    text += log.torque_on[i] != 0 ? ",1" : ",0";
    for (const CsvColumn& column : kColumns)
      if (isKnown(log.*column.values)) append(text += ',', (log.*column.values)[i] * column.factor);
    text += '\n';
  }
  return text;
}

void writeCase(const Case& c, const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  const bool plain = fitsBaseline(c);
  writeTextFile(fs::path{folder} / "case.json", caseAsJson(c, !plain));
  if (!plain) writeTextFile(fs::path{folder} / "model.ini", twin::writeModel(c.model));
  for (const std::vector<Trajectory>* const logs : {&c.logs, &c.others})
    for (const Trajectory& log : *logs) {
      const fs::path path = fs::path{folder} / log.file;
      fs::create_directories(path.parent_path(), failed);
      writeTextFile(path, logAsCsv(log));
    }
}

}  // namespace darwinop::gap
