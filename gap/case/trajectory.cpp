// The rows of a plain log: columns found by name, units from the end of the name.
#include <array>
#include <cmath>
#include <limits>

#include "core/text/unit_factor.hpp"
#include "experiments/logs/header.hpp"
#include "experiments/logs/units.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"

namespace darwinop::gap {
namespace {

constexpr const char* kEmpty = " is empty; leave the row out where it was not measured";
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<std::string_view, 2> kAngles{"rad", "deg"};
constexpr std::array<std::string_view, 3> kSpeeds{"rad/s", "deg/s", "rpm"};
constexpr std::array<std::string_view, 1> kShares{"%"}, kVolts{"V"}, kDegrees{"degC"};

struct Wanted {
  std::string_view name;   // without unit
  std::string_view usual;  // as it is best written
  std::span<const std::string_view> units;
  std::string_view si;
  std::vector<double> Trajectory::*into;
  bool needed;
};
const std::array kWanted{
    Wanted{"goal", "goal_rad", kAngles, "rad", &Trajectory::goal_rad, true},
    Wanted{"pos", "pos_rad", kAngles, "rad", &Trajectory::position_rad, true},
    Wanted{"speed", "speed_rad_s", kSpeeds, "rad/s", &Trajectory::speed_rad_s, false},
    Wanted{"load", "load_pct", kShares, "", &Trajectory::load, false},
    Wanted{"volt", "volt_V", kVolts, "V", &Trajectory::volt_v, false},
    Wanted{"temp", "temp_C", kDegrees, "degC", &Trajectory::temp_c, false},
};

const logs::Column* columnFor(const logs::Log& log, const Wanted& wanted) {
  const logs::Column* found = nullptr;
  for (const logs::Column& column : log.columns) {
    const std::string_view bare = logs::withoutSuffix(column.name);
    const bool alike = bare == wanted.name || column.name.starts_with(std::string{wanted.name} + "_");
    if (!alike) continue;
    if (found != nullptr)
      throw BadInput(log.file + ": columns " + logs::quotedField(found->name) + " and " +
                     logs::quotedField(column.name) + " both contain the " + std::string{wanted.name} +
                     "; keep one of the two");
    found = &column;
  }
  if (found == nullptr && wanted.needed)
    throw BadInput(log.file + ": no column " + std::string{wanted.usual} +
                   "; a log of a case needs t_s, goal_rad, "
                   "torque_on and pos_rad, and preferably has load_pct, volt_V and temp_C as well");
  return found;
}

/// Counts in SI units; NaN stays.
void takeRaw(const logs::Log& log, const logs::Column& column, const Encodings& raw,
             const std::vector<std::size_t>& rows, std::vector<double>& values) {
  const auto found = raw.find(column.name);
  if (found == raw.end())
    throw BadInput(log.file + ": column " + logs::quotedField(column.name) + " " + messages::kNoEncoding +
                   "; declare it in `encodings` of the case, docs/gap/cases.md has the names");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double count = column.values[rows[i]];
    values[i] = found->second->decode(count);
    if (std::isnan(values[i]) && !std::isnan(count))
      throw BadInput(log.file + ", line " + std::to_string(log.lines[rows[i]]) + ": " + column.name +
                     messages::kNotCount);
  }
}

double factorOf(const logs::Log& log, const logs::Column& column, const Wanted& wanted) {
  std::string allowed;
  for (const std::string_view unit : wanted.units) {
    if (unit == column.unit) return text::unitFactor(unit, wanted.si).value();
    allowed.append(allowed.empty() ? "" : " or ").append(unit);
  }
  throw BadInput(log.file + ": the unit of column " + logs::quotedField(column.name) + " is " +
                 (column.unit.empty() ? "not known" : column.unit) + "; it has to be " + allowed +
                 ", at the end of the name: " + std::string{wanted.usual});
}

void take(const logs::Log& log, const Encodings& raw, const Wanted& wanted, const std::vector<std::size_t>& rows,
          Trajectory& into) {
  std::vector<double>& values = into.*wanted.into;
  const logs::Column* column = columnFor(log, wanted);
  values.assign(rows.size(), kNone);
  if (column == nullptr) return;
  if (column->name == std::string{wanted.name} + "_raw") {
    takeRaw(log, *column, raw, rows, values);
    for (std::size_t i = 0; i < rows.size() && wanted.into == &Trajectory::goal_rad; ++i)
      if (std::isnan(values[i]))
        throw BadInput(log.file + ", line " + std::to_string(log.lines[rows[i]]) + ": " + column->name + kEmpty);
    return;
  }
  const double factor = factorOf(log, *column, wanted);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double value = column->values[rows[i]];
    if (std::isinf(value) || (wanted.needed && std::isnan(value) && wanted.into != &Trajectory::position_rad))
      throw BadInput(log.file + ", line " + std::to_string(log.lines[rows[i]]) + ": " + column->name +
                     (std::isnan(value) ? kEmpty : " is infinite; leave the row out"));
    values[i] = value * factor;
  }
}

/// Other columns of that name are left out: nothing needs a current.
void takeCurrent(const logs::Log& log, const Encodings& raw, const std::vector<std::size_t>& rows, Trajectory& into) {
  into.current_a.assign(rows.size(), kNone);
  if (const logs::Column* const counts = log.find("current_raw"); counts != nullptr && raw.contains(counts->name))
    takeRaw(log, *counts, raw, rows, into.current_a);
  if (const logs::Column* const amperes = log.find("current_A"))
    for (std::size_t i = 0; i < rows.size(); ++i) into.current_a[i] = amperes->values[rows[i]];
}

/// When a row's goal was written and its servo read: both or neither.
void takeSchedule(const logs::Log& log, const std::vector<std::size_t>& rows, Trajectory& into) {
  const logs::Column *const written = log.find("written_s"), *const read = log.find("read_s");
  if (written == nullptr && read == nullptr) return;
  if (written == nullptr || read == nullptr) throw BadInput(log.file + ": " + messages::kHalfSchedule);
  for (const std::size_t row : rows) {
    const double written_s = written->values[row], read_s = read->values[row];
    if (!(written_s >= 0 && written_s <= read_s && std::isfinite(read_s)))
      throw BadInput(log.file + ", line " + std::to_string(log.lines[row]) + ": " + messages::kScheduleOrder);
    into.written_s.push_back(written_s);
    into.read_s.push_back(read_s);
  }
}

void takeTorque(const logs::Log& log, const std::vector<std::size_t>& rows, Trajectory& into) {
  const logs::Column* column = log.find("torque_on");
  if (column == nullptr)
    throw BadInput(log.file + ": no column torque_on; write 1 in each row while the servo is on, 0 while it is limp");
  for (const std::size_t row : rows) {
    const double value = column->values[row];
    if (value != 0 && value != 1)
      throw BadInput(log.file + ", line " + std::to_string(log.lines[row]) + ": torque_on is " +
                     (std::isnan(value) ? "empty" : std::to_string(value)) + "; it has to be 0 or 1");
    into.torque_on.push_back(value != 0 ? 1 : 0);
  }
}

void fillFromPlain(const logs::Log& log, const Encodings& raw, LogEntry& entry) {
  if (entry.joint)
    throw BadInput(log.file +
                   ": a plain log is of one joint, and \"joint\" is for recordings of the runtime; take "
                   "it away from the case");
  Trajectory& out = entry.head;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (log.seconds(row) >= entry.from_s && log.seconds(row) <= entry.to_s) rows.push_back(row);
  for (const std::size_t row : rows) {
    out.time_s.push_back(log.seconds(row));
    out.lines.push_back(log.lines[row]);
  }
  for (const Wanted& wanted : kWanted) take(log, raw, wanted, rows, out);
  takeCurrent(log, raw, rows, out);
  takeTorque(log, rows, out);
  takeSchedule(log, rows, out);
  out.is_phase_known = entry.firmware_in_step;
  if (!entry.p_register)
    throw BadInput(log.file + ": " + messages::kNoPRegister + "; add \"kp\": 32, or its value, to the log");
  out.p_register = *entry.p_register;
}

}  // namespace

void fillTrajectory(const logs::Log& log, const Encodings& raw, LogEntry& entry, std::vector<std::string>& warnings) {
  if (log.recording)
    fillFromRecording(log, entry, warnings);
  else
    fillFromPlain(log, raw, entry);
  entry.head.session_start_s = entry.session_start_s.value_or(0);
  entry.head.is_session_known = entry.session_start_s.has_value();
  for (double& goal : entry.head.goal_rad) goal -= entry.hangs_at_rad;
  if (entry.head.goal_before_rad) *entry.head.goal_before_rad -= entry.hangs_at_rad;
  for (double& position : entry.head.position_rad) position -= entry.hangs_at_rad;
}

}  // namespace darwinop::gap
