// One joint of a recording of the runtime as a log of a case; docs/logs.md lists the columns.
//
// A cycle writes the goals and reads the servos right behind that (runtime/cycle.cpp), and a row is what one cycle
// wrote and read. Between the two lie a few periods of the firmware, which act on the goal already: the load shows
// them, the position hardly. The bytes on the wire give both times. A recording without them counts as read before its
// goals were written, GoalOrder::kAfterRead. `commanded` has a value while the joint is driven: torque is on.
#include <cmath>
#include <vector>

#include "core/conversions.hpp"
#include "core/registers.hpp"
#include "gap/case/bad_rows.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"
#include "gap/case/servo_columns.hpp"
#include "gap/case/wire_schedule.hpp"

namespace darwinop::gap {
namespace {

/// A gain or limit that must be constant over a log: the same in all rows that have it while the joint is driven.
std::optional<double> constant(const logs::Log& log, const ServoColumns& c, const std::vector<double>& values,
                               const std::vector<std::size_t>& rows, const char* what) {
  std::optional<double> found;
  for (const std::size_t row : rows) {
    if (std::isnan(values[row]) || std::isnan(c.goal->values[row])) continue;
    if (found && *found != values[row])
      throw BadInput(log.file + ", line " + std::to_string(log.lines[row]) + ": the " + what +
                     " changes here, and a log of a case has one; cut it with from_s and to_s");
    found = values[row];
  }
  return found;
}

std::vector<std::size_t> rowsOf(const logs::Log& log, const LogEntry& entry, const ServoColumns& c,
                                std::vector<std::string>& warnings) {
  std::vector<std::size_t> rows;
  std::size_t without = 0;
  bool driven = false;  // before a joint is driven for the first time there is no goal
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (log.seconds(row) < entry.from_s || log.seconds(row) > entry.to_s) continue;
    driven = driven || !std::isnan(c.goal->values[row]);
    if (!driven) continue;
    if (std::isnan(c.position->values[row]))
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

/// When the joint was written and read in these rows. Nothing if the recording has not all joints, or not `bus.wire`.
void takeSchedule(const logs::Log& log, Joint joint, const std::vector<std::size_t>& rows, Trajectory& into) {
  std::vector<Trajectory> all(kJoints);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::string name{kJointTable[i].name};
    const logs::Column* const position = log.find(name + ".position");
    const logs::Column* const voltage = log.find(name + ".voltage");
    if (position == nullptr || voltage == nullptr) return;
    all[i].position_rad = position->values;
    all[i].volt_v = voltage->values;
  }
  fillWireSchedule(log, all);
  const Trajectory& own = all[index(joint)];
  if (!own.isReadAfterWrite()) return;
  for (const std::size_t row : rows) {
    into.written_s.push_back(own.written_s[row]);
    into.read_s.push_back(own.read_s[row]);
  }
  into.is_phase_known = isInLockstep(log);
}

/// The goal as the servo's register has it.
double inTicks(double goal_rad) {
  return radFromTicks(ticksFromRad(Rad{goal_rad})).value;
}

}  // namespace

void fillFromRecording(const logs::Log& log, LogEntry& entry, std::vector<std::string>& warnings) {
  if (!entry.joint) throw BadInput(log.file + ": " + messages::kJointNotGiven + ": \"joint\": \"ArmUpperR\"");
  const ServoColumns c = servoColumns(log, *entry.joint, NeededColumns::kAll);
  const std::vector<std::size_t> rows = rowsOf(log, entry, c, warnings);
  Trajectory& out = entry.head;
  double goal = c.goal->values[rows.front()];
  if (std::isnan(goal)) goal = c.position->values[rows.front()];
  for (const std::size_t row : rows) {
    if (!std::isnan(c.goal->values[row])) goal = c.goal->values[row];  // limp: the last one, which nothing follows
    out.time_s.push_back(log.seconds(row) - log.seconds(rows.front()));
    appendRow(log, c, row, inTicks(goal), out);
  }
  if (out.goal_before_rad) out.goal_before_rad = inTicks(*out.goal_before_rad);
  takeSchedule(log, *entry.joint, rows, out);
  constexpr const Register& gain = find(kMx28, "p_gain");
  const std::optional<double> p_gain = constant(log, c, c.p_gain->values, rows, "P gain");
  const std::optional<double> p_register = p_gain ? std::optional{*p_gain / gain.scale} : std::nullopt;
  if (p_register && entry.p_register && std::abs(*p_register - *entry.p_register) > 0.5)
    throw BadInput(log.file + ": its P gain is register " + std::to_string(std::lround(*p_register)) +
                   ", but the case has \"kp\": " + std::to_string(std::lround(*entry.p_register)) +
                   "; remove kp, the recording has it");
  out.p_register = p_register.value_or(entry.p_register.value_or(out.p_register));  // 32: where the servo starts
  const std::optional<double> limit = constant(log, c, c.speed_limit->values, rows, "speed limit");
  if (limit && out.speed_limit_rad_s == 0) out.speed_limit_rad_s = *limit;
}

}  // namespace darwinop::gap
