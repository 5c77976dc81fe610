// One joint of a recording of the runtime as a log of a case; docs/logs.md lists the columns.
//
// A cycle writes the goals and reads the servos right behind that (runtime/cycle.cpp), and a row is what one cycle
// wrote and read. Between the two lies a millisecond or so, in which nothing moves: a row's goal shows in the next row
// first, as if it had been written after the read, GoalOrder::kAfterRead. `commanded` has a value while the
// joint is driven: torque is on.
#include <cmath>
#include <limits>

#include "core/registers.hpp"
#include "gap/case/bad_rows.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"

namespace darwinop::gap {
namespace {

struct JointColumns {
  const std::vector<double>&goal, &position, &speed, &load, &volt, &temperature, &p_gain, &speed_limit;
};

/// The P gain, Kp; older recordings do not name the unit.
void checkGainUnit(const logs::Log& log, Joint joint) {
  const logs::Column& gain =
      log.column(std::string{kJointTable[static_cast<std::size_t>(joint)].name} + ".asked_p_gain");
  if (!gain.unit.empty() && gain.unit != "Kp")
    throw BadInput(log.file + ": column " + gain.name + " is in " + gain.unit +
                   ", expected Kp (the servo's register / 8); convert it");
}

JointColumns columnsOf(const logs::Log& log, Joint joint) {
  const std::string prefix = std::string{kJointTable[static_cast<std::size_t>(joint)].name} + ".";
  const auto column = [&](const char* name) -> const std::vector<double>& {
    try {
      return log.column(prefix + name).values;
    } catch (const std::runtime_error& error) {
      throw BadInput(error.what());
    }
  };
  return {column("commanded"), column("position"),    column("velocity"),     column("load"),
          column("voltage"),   column("temperature"), column("asked_p_gain"), column("asked_speed")};
}

/// A gain or limit that must be constant over a log: the same in all rows that have it while the joint is driven.
std::optional<double> constant(const logs::Log& log, const JointColumns& c, const std::vector<double>& values,
                               const std::vector<std::size_t>& rows, const char* what) {
  std::optional<double> found;
  for (const std::size_t row : rows) {
    if (std::isnan(values[row]) || std::isnan(c.goal[row])) continue;
    if (found && *found != values[row])
      throw BadInput(log.file + ", line " + std::to_string(log.lines[row]) + ": the " + what +
                     " changes here, and a log of a case has one; cut it with from_s and to_s");
    found = values[row];
  }
  return found;
}

std::vector<std::size_t> rowsOf(const logs::Log& log, const LogEntry& entry, const JointColumns& c,
                                std::vector<std::string>& warnings) {
  std::vector<std::size_t> rows;
  std::size_t without = 0;
  bool driven = false;  // before a joint is driven for the first time there is no goal
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (log.seconds(row) < entry.from_s || log.seconds(row) > entry.to_s) continue;
    driven = driven || !std::isnan(c.goal[row]);
    if (!driven) continue;
    if (std::isnan(c.position[row]))
      ++without;
    else
      rows.push_back(row);
  }
  if (rows.empty())
    throw BadInput(log.file +
                   ": the joint is never driven and answers between from_s and to_s; is it the right joint?");
  const double share = double(without) / double(rows.size() + without);
  const std::string sentence = log.file + ": the servo did not answer in " + std::to_string(without) + " of " +
                               std::to_string(rows.size() + without) + " rows";
  if (share > kMostMasked) throw BadInput(sentence + "; check its cable and measure again");
  if (without > 0) warnings.push_back(sentence + ", which are left out");
  return rows;
}

}  // namespace

void fillFromRecording(const logs::Log& log, LogEntry& entry, std::vector<std::string>& warnings) {
  if (!entry.joint) throw BadInput(log.file + ": " + messages::kJointNotGiven + ": \"joint\": \"ArmUpperR\"");
  const JointColumns c = columnsOf(log, *entry.joint);
  checkGainUnit(log, *entry.joint);
  const std::vector<std::size_t> rows = rowsOf(log, entry, c, warnings);
  Trajectory& out = entry.head;
  double goal = c.goal[rows.front()];
  if (std::isnan(goal)) goal = c.position[rows.front()];
  for (const std::size_t row : rows) {
    if (!std::isnan(c.goal[row])) goal = c.goal[row];  // limp: the last one, which nothing follows
    out.time_s.push_back(log.seconds(row) - log.seconds(rows.front()));
    out.lines.push_back(log.lines[row]);
    out.goal_rad.push_back(goal);
    out.torque_on.push_back(std::isnan(c.goal[row]) ? 0 : 1);
    out.position_rad.push_back(c.position[row]);
    out.speed_rad_s.push_back(c.speed[row]);
    out.load.push_back(c.load[row]);
    out.volt_v.push_back(c.volt[row]);
    out.temp_c.push_back(c.temperature[row]);
  }
  constexpr const Register& gain = find(kMx28, "p_gain");
  const std::optional<double> p_gain = constant(log, c, c.p_gain, rows, "P gain");
  const std::optional<double> p_register = p_gain ? std::optional{*p_gain / gain.scale} : std::nullopt;
  if (p_register && entry.p_register && std::abs(*p_register - *entry.p_register) > 0.5)
    throw BadInput(log.file + ": its P gain is register " + std::to_string(std::lround(*p_register)) +
                   ", but the case has \"kp\": " + std::to_string(std::lround(*entry.p_register)) +
                   "; remove kp, the recording has it");
  out.p_register = p_register.value_or(entry.p_register.value_or(out.p_register));  // 32: where the servo starts
  const std::optional<double> limit = constant(log, c, c.speed_limit, rows, "speed limit");
  if (limit && out.speed_limit_rad_s == 0) out.speed_limit_rad_s = *limit;
}

}  // namespace darwinop::gap
