// One log of BAM.
#include "gap/case/bam_log.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/case/encodings.hpp"
#include "gap/case/fields.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

/// A number, true or false of an entry; NaN without one.
double valueOf(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end()) return kNotThere;
  if (found->is_boolean()) return found->get<bool>() ? 1 : 0;
  return found->is_number() ? found->get<double>() : kNotThere;
}

struct LoadRule {
  bool (*fits)(double greatest, double least, bool whole);
  const char* encoding;  // null: a share, times `scale`
  double scale;
  const char* reason;
};
/// The first that fits the columns of all logs.
constexpr LoadRule kLoadRules[] = {
    {[](double most, double, bool whole) { return whole && most > 32'767 && most <= 65'535; }, "load_int16", 0,
     "counts above 32767: 16 bits in two's complement, logged without sign"},
    {[](double most, double least, bool whole) { return whole && most >= 1'024 && most < 2'048 && least >= 0; },
     "load_bit10", 0, "counts up to 2047 and none below 0: bit 10 is the sign, 0.1 % a count"},
    {[](double most, double least, bool whole) { return !whole && std::max(most, -least) <= 1.01; }, nullptr, 1,
     "fractions, nothing beyond 1: a share of the greatest duty"},
    {[](double most, double least, bool whole) { return !whole && std::max(most, -least) <= 101; }, nullptr, 0.01,
     "fractions, nothing beyond 100: percent"},
    {[](double most, double least, bool whole) { return whole && std::max(most, -least) <= 1'023; }, "load_int16", 0,
     "whole numbers with sign up to 1023: 0.1 % a count"},
};

/// Null: the unit of this column, which the files do not give, is not recognized.
const LoadRule* ruleFor(const std::vector<BamLog>& logs, const std::vector<double> BamLog::*column) {
  double most = 0, least = 0;
  bool whole = true;
  for (const BamLog& one : logs)
    for (const double value : one.*column) {
      if (std::isnan(value)) continue;
      most = std::max(most, value), least = std::min(least, value);
      whole = whole && value == std::nearbyint(value);
    }
  const auto* const found =
      std::ranges::find_if(kLoadRules, [&](const LoadRule& rule) { return rule.fits(most, least, whole); });
  return found == std::end(kLoadRules) ? nullptr : found;
}

void takeLoad(const LoadRule& rule, const std::vector<double>& column, const char* key, BamLog& into) {
  // Duties of the X series are counts of 885, in two's complement.
  const bool x_series = !into.motor.empty() && (into.motor.front() == 'x' || into.motor.front() == 'X');
  const bool duty = rule.encoding != nullptr && std::string_view{rule.encoding} == "load_int16" && x_series;
  const char* const name = duty ? "pwm_int16_885" : rule.encoding;
  std::ranges::transform(column, into.log.load.begin(), [&](double value) {
    return name == nullptr ? value * rule.scale : findEncoding(name)->decode(value);
  });
  into.notes.push_back(into.log.file + ": " + key + " is read as load, " + rule.reason +
                       (name == nullptr ? "" : ", encoding " + std::string{name}));
}

bool isAllZero(const std::vector<double>& column) {
  return std::ranges::all_of(column, [](double value) { return std::isnan(value) || value == 0; });
}

void takeRows(const Json& entries, const std::string& file, BamLog& into) {
  Trajectory& log = into.log;
  std::size_t dropped = 0, without_torque_enable = 0;
  for (const Json& entry : entries) {
    if (!entry.is_object()) throw BadInput(file + ": `entries` " + messages::kNotBamRow);
    const double time_s = valueOf(entry, "timestamp"), goal = valueOf(entry, "goal_position");
    if (!std::isfinite(time_s) || !std::isfinite(goal)) throw BadInput(file + ": `entries` " + messages::kNotBamRow);
    if (!log.time_s.empty() && !(time_s > log.time_s.back())) {
      ++dropped;
      continue;
    }
    log.time_s.push_back(time_s);
    log.goal_rad.push_back(goal);
    const double torque_on = valueOf(entry, "torque_enable");
    if (std::isnan(torque_on)) ++without_torque_enable;
    log.torque_on.push_back(torque_on == 0 ? 0 : 1);
    log.position_rad.push_back(valueOf(entry, "position"));
    log.speed_rad_s.push_back(valueOf(entry, "speed"));
    log.volt_v.push_back(valueOf(entry, "input_volts"));
    log.temp_c.push_back(valueOf(entry, "temp"));
    log.current_a.push_back(valueOf(entry, "current"));
    log.lines.push_back(static_cast<std::uint32_t>(&entry - &entries.front()));
    into.load.push_back(valueOf(entry, "load"));
    into.torque.push_back(valueOf(entry, "torque"));
  }
  log.load.assign(log.rows(), kNotThere);
  if (without_torque_enable > 0)
    into.notes.push_back(log.file + ": " + std::to_string(without_torque_enable) + messages::kNoTorqueEnable);
  if (dropped > 0)
    into.notes.push_back(log.file + ": " + std::to_string(dropped) + " rows whose time does not increase are left out");
}

}  // namespace

BamLog parseBamLog(std::string_view json, const std::string& file, const std::string& name) {
  const Json parsed = parseJson(json, file);
  Fields head{parsed, file, ""};
  BamLog out;
  out.log.file = name + ".csv";
  out.motor = head.text("motor", "");
  out.log.kind = head.text("trajectory", name);
  out.log.is_session_known = false;  // the clock of each log is its own
  out.log.p_register = head.number("kp", {"", 0, 16'383});
  out.log.payload_kg = head.number("mass", {"kg", 0, 20});
  out.log.length_m = head.number("length", {"m", 0.005, 2});
  out.log.arm_mass_kg = head.number("arm_mass", {"kg", 0, 20}, 0);
  if (head.has("vin")) out.log.supply_v = head.number("vin", {"V", 3, 30});
  const auto entries = parsed.find("entries");
  if (entries == parsed.end() || !entries->is_array() || entries->empty())
    head.fail("entries", std::string{messages::kMissing} + "the rows of the log");
  takeRows(*entries, file, out);
  return out;
}

void convertLoads(std::vector<BamLog>& logs) {
  const bool of_load = !std::ranges::all_of(logs, isAllZero, &BamLog::load);
  const auto column = of_load ? &BamLog::load : &BamLog::torque;
  const char* const key = of_load ? "load" : "torque";
  const LoadRule* const rule = ruleFor(logs, column);
  for (BamLog& one : logs) {
    const std::string file = one.log.file + ": ";
    if (isAllZero(one.*column)) {
      if (std::ranges::any_of(one.load, [](double value) { return !std::isnan(value); }))
        one.notes.push_back(file + messages::kLoadIsZero + messages::kNotMeasured);
      continue;
    }
    if (rule == nullptr) {
      one.notes.push_back(file + key + messages::kLoadNotRecognized);
      continue;
    }
    takeLoad(*rule, one.*column, key, one);
    if (!of_load) one.notes.back() += "; " + std::string{messages::kLoadIsZero};
  }
}

std::string asBamJson(const Case& c, const Trajectory& log, std::string_view motor) {
  const twin::Pendulum arm = armOf(c, log);
  Json entries = Json::array();
  // BAM's recorder writes before it reads: a command that was written after a read belongs to the next row.
  const bool after_read = c.goal_order == GoalOrder::kAfterRead;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const std::size_t command = after_read && row > 0 ? row - 1 : row;
    Json entry = {{"timestamp", log.time_s[row]},
                  {"goal_position", log.goal_rad[command]},
                  {"torque_enable", log.torque_on[command] != 0}};
    const auto add = [&](const char* key, const std::vector<double>& column) {
      if (row < column.size() && !std::isnan(column[row])) entry[key] = column[row];
    };
    add("position", log.position_rad);
    add("speed", log.speed_rad_s);
    add("load", log.load);
    add("input_volts", log.volt_v);
    add("temp", log.temp_c);
    add("current", log.current_a);
    entries.push_back(std::move(entry));
  }
  return Json{{"mass", log.payload_kg}, {"arm_mass", arm.arm_mass_kg}, {"length", arm.length_m},
              {"kp", log.p_register},   {"vin", supplyOf(c, log)},     {"motor", motor},
              {"trajectory", log.kind}, {"entries", entries}}
             .dump(1) +
         "\n";
}

}  // namespace darwinop::gap
