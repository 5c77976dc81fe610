#include "gap/case/servo_columns.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace darwinop::gap {
namespace {

/// Null if it may be missing and is. Older recordings do not name every unit.
const logs::Column* columnOf(const logs::Log& log, const std::string& name, const char* unit, bool needed) {
  const logs::Column* column = log.find(name);
  if (column == nullptr) {
    if (!needed) return nullptr;
    try {
      column = &log.column(name);
    } catch (const std::runtime_error& error) {
      throw BadInput(error.what());
    }
  }
  if (!column->unit.empty() && column->unit != unit)
    throw BadInput(log.file + ": column " + column->name + " is in " + column->unit + ", expected " + unit +
                   (std::string_view{unit} == "Kp" ? " (the servo's register / 8)" : "") + "; convert it");
  return column;
}

double valueAt(const logs::Column* column, std::size_t row) {
  return column == nullptr ? std::numeric_limits<double>::quiet_NaN() : column->values[row];
}

}  // namespace

ServoColumns servoColumns(const logs::Log& log, Joint joint, NeededColumns needed) {
  const bool all = needed == NeededColumns::kAll;
  const auto column = [&](const char* name, const char* unit, bool has_to_be_there) {
    return columnOf(log, std::string{row(joint).name} + "." + name, unit, has_to_be_there);
  };
  return {.goal = column("commanded", "rad", true),
          .position = column("position", "rad", true),
          .load = column("load", "", true),
          .p_gain = column("asked_p_gain", "Kp", true),
          .speed = column("velocity", "rad/s", all),
          .voltage = column("voltage", "V", all),
          .temperature = column("temperature", "degC", all),
          .speed_limit = column("asked_speed", "rad/s", all)};
}

void appendRow(const logs::Log& log, const ServoColumns& columns, std::size_t row, double goal_rad, Trajectory& into) {
  into.lines.push_back(log.lines[row]);
  into.goal_rad.push_back(goal_rad);
  into.torque_on.push_back(std::isnan(columns.goal->values[row]) ? 0 : 1);
  into.position_rad.push_back(columns.position->values[row]);
  into.speed_rad_s.push_back(valueAt(columns.speed, row));
  into.load.push_back(columns.load->values[row]);
  into.volt_v.push_back(valueAt(columns.voltage, row));
  into.temp_c.push_back(valueAt(columns.temperature, row));
}

}  // namespace darwinop::gap
