// One log of BAM.
#include "gap/case/bam_log.hpp"

#include <cmath>
#include <limits>

#include "gap/case/chain.hpp"
#include "gap/case/column_bounds.hpp"
#include "gap/case/fields.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

// Entries in a row whose time is not after that of those before: lone false readings are fewer.
constexpr std::size_t kMostOffTheClock = 3;

/// A number, true or false of an entry; NaN without one.
double valueOf(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end()) return kNotThere;
  if (found->is_boolean()) return found->get<bool>() ? 1 : 0;
  return found->is_number() ? found->get<double>() : kNotThere;
}

/// The goal of an entry: of a limp row without one, which some recorders write, the goal before.
double goalOf(const Json& entry, const Trajectory& log) {
  const double goal = valueOf(entry, "goal_position");
  if (std::isfinite(goal) || valueOf(entry, "torque_enable") != 0) return goal;
  return log.goal_rad.empty() ? valueOf(entry, "position") : log.goal_rad.back();
}

void takeEntry(const Json& entry, double time_s, double goal, std::size_t number, BamLog& into) {
  Trajectory& log = into.log;
  log.time_s.push_back(time_s);
  log.goal_rad.push_back(goal);
  log.torque_on.push_back(valueOf(entry, "torque_enable") == 0 ? 0 : 1);
  log.position_rad.push_back(valueOf(entry, "position"));
  log.speed_rad_s.push_back(valueOf(entry, "speed"));
  log.volt_v.push_back(valueOf(entry, "input_volts"));
  log.temp_c.push_back(valueOf(entry, "temp"));
  log.current_a.push_back(valueOf(entry, "current"));
  log.lines.push_back(static_cast<std::uint32_t>(number));
  into.load.push_back(valueOf(entry, "load"));
  into.torque.push_back(valueOf(entry, "torque"));
}

/// Entries whose time is none, or not after that of the entries before: lone ones are left out. A clock that was set
/// has many: what is before and after them are two logs.
std::vector<bool> offTheClock(const Json& entries, const std::string& file) {
  std::vector<double> time_s;
  std::vector<std::size_t> known;
  for (const Json& entry : entries) {
    if (!entry.is_object()) throw BadInput(file + ": `entries` " + messages::kNotBamRow);
    time_s.push_back(valueOf(entry, "timestamp"));
    if (std::isfinite(time_s.back())) known.push_back(time_s.size() - 1);
  }
  std::vector<bool> off(time_s.size(), true);
  for (const std::size_t row : known) off[row] = false;
  for (const std::size_t row :
       outsideLongestChain(known, [&](std::size_t i, std::size_t j) { return time_s[j] > time_s[i]; }))
    off[row] = true;
  std::size_t in_a_row = 0;
  for (std::size_t row = 0; row < off.size(); ++row) {
    in_a_row = off[row] ? in_a_row + 1 : 0;
    if (in_a_row > kMostOffTheClock)
      throw BadInput(file + ": `entries[" + std::to_string(row + 1 - in_a_row) + "]` " + messages::kClockWasSet);
  }
  return off;
}

void takeRows(const Json& entries, const std::string& file, BamLog& into) {
  const std::vector<bool> off = offTheClock(entries, file);
  std::size_t late = 0, without_goal = 0, without_torque_enable = 0;
  for (std::size_t row = 0; row < entries.size(); ++row) {
    const double goal = goalOf(entries[row], into.log);
    if (off[row]) {
      ++late;
    } else if (!std::isfinite(goal)) {
      ++without_goal;
    } else {
      if (std::isnan(valueOf(entries[row], "torque_enable"))) ++without_torque_enable;
      takeEntry(entries[row], valueOf(entries[row], "timestamp"), goal, row, into);
    }
  }
  if (!areFew(late + without_goal, entries.size())) throw BadInput(file + ": `entries` " + messages::kNotBamRow);
  into.log.load.assign(into.log.rows(), kNotThere);
  const auto note = [&](std::size_t number, const std::string& what) {
    if (number > 0)
      into.notes.push_back(into.log.file + ": " + std::to_string(number) + " of " + std::to_string(entries.size()) +
                           what);
  };
  note(without_torque_enable, messages::kNoTorqueEnable);
  note(late, " rows are left out: their time does not increase");
  note(without_goal, " rows are left out: they have no goal");
}

/// Python writes NaN and Infinity, which JSON does not have, for what is not known.
std::string withoutNotNumbers(std::string_view json) {
  std::string out{json};
  bool in_text = false;
  for (std::size_t at = 0; at < out.size(); ++at) {
    if (out[at] == '"' && (at == 0 || out[at - 1] != '\\')) in_text = !in_text;
    if (in_text) continue;
    for (const std::string_view word : {"NaN", "-Infinity", "Infinity"})
      if (out.compare(at, word.size(), word) == 0) out.replace(at, word.size(), "null");
  }
  return out;
}

}  // namespace

BamLog parseBamLog(std::string_view json, const std::string& file, const std::string& name) {
  const Json parsed = parseJson(withoutNotNumbers(json), file);
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
  if (valueOf(parsed, "vin") > 0) out.log.supply_v = head.number("vin", {"V", 3, 30});  // 0: not known
  const auto entries = parsed.find("entries");
  if (entries == parsed.end() || !entries->is_array() || entries->empty())
    head.fail("entries", std::string{messages::kMissing} + "the rows of the log");
  takeRows(*entries, file, out);
  dropOddColumns(out);
  return out;
}

std::string asBamJson(const Case& c, const Trajectory& log, std::string_view motor) {
  const twin::Pendulum arm = armOf(c, log);
  Json entries = Json::array();
  // BAM's recorder writes before it reads: a command that was written after a read belongs to the next row.
  const bool after_read = c.goal_order == GoalOrder::kAfterRead && !log.isReadAfterWrite();
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
