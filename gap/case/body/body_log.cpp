// The rows of one recording of a whole robot.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/conversions.hpp"
#include "core/registers.hpp"
#include "core/servo_limits.hpp"
#include "core/units.hpp"
#include "gap/case/bad_rows.hpp"
#include "gap/case/body/asked_limits.hpp"
#include "gap/case/body/fall.hpp"
#include "gap/case/body/lost_rows.hpp"
#include "gap/case/body/parse_body_case.hpp"
#include "gap/case/servo_columns.hpp"
#include "gap/case/wire_schedule.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kFewestRows = 20;        // 0.3 s at 16 ms
constexpr double kTurns = 2 * 2 * kPi;         // rad
constexpr double kFastest = 2 * 34.907;        // rad/s, twice the range of the gyroscope
constexpr double kHardest = 2 * 4 * kGravity;  // m/s2, twice that of the accelerometer

/// Throws BadInput for the first value outside of the range that its unit has in a robot.
void checkRange(const logs::Log& log, const logs::Column& column, double low, double high, const char* advice) {
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (const double value = column.values[row]; value < low || value > high)
      throw BadInput(log.file + ", line " + std::to_string(log.lines[row]) + ": column " + column.name + " has " +
                     std::to_string(value) + ", outside of " + std::to_string(low) + " to " + std::to_string(high) +
                     "; " + advice);
}

const logs::Column& sensorColumn(const logs::Log& log, const std::string& name, const char* unit) {
  try {
    const logs::Column& column = log.column(name);
    if (column.unit == unit) return column;
    throw BadInput(log.file + ": column " + name + " is in " + (column.unit.empty() ? "no unit" : column.unit) +
                   ", expected " + unit + "; convert it");
  } catch (const BadInput&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
}

AxesColumns axesOf(const logs::Log& log, const std::string& sensor, const char* unit, double greatest) {
  AxesColumns out;
  constexpr std::array kNames{"x", "y", "z"};
  for (std::size_t axis = 0; axis < out.size(); ++axis) {
    const logs::Column& column = sensorColumn(log, sensor + "." + kNames[axis], unit);
    checkRange(log, column, -greatest, greatest, "is the unit right?");
    out[axis] = column.values;
  }
  return out;
}

/// False: never. A servo that is silent for long has another fault than a model can have.
bool answers(const logs::Log& log, const logs::Column& position) {
  const auto silent = std::ranges::count_if(position.values, [](double value) { return std::isnan(value); });
  if (silent == std::ssize(position.values)) return false;
  if (static_cast<double>(silent) > kMostMasked * static_cast<double>(log.rows()))
    throw BadInput(log.file + ": column " + position.name + " is empty in " + std::to_string(silent) + " of " +
                   std::to_string(log.rows()) + " rows; check the cable of that servo and measure again");
  return true;
}

/// The goal as the servo's register has it.
double inTicks(double goal_rad) {
  return radFromTicks(ticksFromRad(Rad{goal_rad})).value;
}

/// The log of these rows alone.
logs::Log withRows(logs::Log log, const std::vector<std::size_t>& rows) {
  if (rows.size() == log.rows()) return log;
  const auto keep = [&rows](auto& values) {
    for (std::size_t i = 0; i < rows.size(); ++i) values[i] = values[rows[i]];
    values.resize(rows.size());
  };
  for (logs::Column& column : log.columns) keep(column.values);
  keep(log.lines);
  return log;
}

/// The rows that the case declares: the log is shorter then.
logs::Log cutToSize(logs::Log log, const BodyLog& head) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (log.seconds(row) >= head.from_s && log.seconds(row) <= head.to_s) rows.push_back(row);
  return withRows(std::move(log), rows);
}

AxesColumns accelerometerOf(const logs::Log& log) {
  return axesOf(log, "accelerometer", "m/s2", kHardest);
}

/// The rows before a fall; `fell_at_s` is set if there is one.
logs::Log cutAtFall(logs::Log log, BodyLog& head) {
  if (head.setup != BodySetup::kFloor) return log;
  std::vector<double> time_s;
  for (std::size_t row = 0; row < log.rows(); ++row) time_s.push_back(log.seconds(row) - log.seconds(0));
  const std::optional<std::size_t> fall = rowOfFall(time_s, accelerometerOf(log));
  if (!fall) return log;
  head.fell_at_s = time_s[*fall];
  std::vector<std::size_t> rows(std::max(*fall, kFewestRows));
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return withRows(std::move(log), rows);
}

Trajectory jointOf(const logs::Log& log, const BodyLog& head, Joint joint) {
  constexpr const Register& gain = find(kMx28, "p_gain");
  const ServoColumns columns = servoColumns(log, joint, NeededColumns::kLaw);
  const bool is_absent = !answers(log, *columns.position);
  checkRange(log, *columns.goal, -kTurns, kTurns, "is it in degrees?");
  checkRange(log, *columns.position, -kTurns, kTurns, "is it in degrees?");
  checkRange(log, *columns.load, -1.01, 1.01, "a load is a fraction of the greatest duty");
  checkRange(log, *columns.p_gain, 0, gain.high * gain.scale, "the gain is the servo's register / 8");
  Trajectory out;
  out.file = head.file;
  out.kind = name(head.setup);
  out.held_out = head.held_out;
  out.joint = joint;
  out.supply_v = head.battery_v;
  out.session_start_s = head.session_start_s;
  out.time_s = head.time_s;
  out.speed_limit_rad_s = speedLimitOf(log, joint);
  double goal = std::isnan(columns.goal->values[0]) ? columns.position->values[0] : columns.goal->values[0];
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (!std::isnan(columns.goal->values[row])) goal = columns.goal->values[row];
    appendRow(log, columns, row, inTicks(goal), out);
    // A controller that asks for no gain gets the factory's.
    const double asked = columns.p_gain->values[row];
    out.p_register_of_row.push_back((std::isnan(asked) ? kDefaultPGain : asked) / gain.scale);
  }
  refuseActiveLimits(log, joint, out);
  if (is_absent) std::ranges::fill(out.goal_rad, 0), std::ranges::fill(out.torque_on, 0);
  return out;
}

}  // namespace

void fillBodyLog(const logs::Log& file, BodyLog& log, std::vector<Trajectory>& joints) {
  logs::Log recording = cutToSize(file, log);
  if (recording.rows() < kFewestRows)
    throw BadInput(recording.file + ": " + std::to_string(recording.rows()) + " rows, and a log needs at least " +
                   std::to_string(kFewestRows) + "; record for longer");
  recording = cutAtFall(std::move(recording), log);
  for (std::size_t row = 0; row < recording.rows(); ++row)
    log.time_s.push_back(recording.seconds(row) - recording.seconds(0));
  log.gyro_rad_s = axesOf(recording, "gyro", "rad/s", kFastest);
  log.accel_m_s2 = accelerometerOf(recording);
  log.board_v = sensorColumn(recording, "board.voltage", "V").values;
  log.lost_rows = lostRows(recording);
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    joints.push_back(jointOf(recording, log, static_cast<Joint>(joint)));
  fillWireSchedule(recording, std::span{joints}.last(kJoints));
  forgetAfterLostRows(recording, std::span{joints}.last(kJoints));  // which reply a row has is known of all
  log.is_phase_known = !joints.back().isReadAfterWrite() || isInLockstep(recording);
}

}  // namespace darwinop::gap
