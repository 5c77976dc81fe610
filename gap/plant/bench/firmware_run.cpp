#include "gap/plant/bench/firmware_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/conversions.hpp"
#include "gap/plant/bench/surroundings.hpp"
#include "gap/plant/row_state.hpp"
#include "gap/plant/write_instant.hpp"

namespace darwinop::gap {
namespace {

constexpr double kFineTicks = 1 << 26;  // the measured positions are in ticks already
constexpr double kInstant = 1e-6;       // of a period

twin::Servo servoFor(const Hypothesis& hypothesis, const double& temperature_c) {
  twin::ServoParameters parameters = hypothesis.servo;
  parameters.ticks_per_rev = kFineTicks;
  parameters.overload_time_s = std::numeric_limits<double>::infinity();
  std::vector<std::unique_ptr<twin::Effect>> effects;
  effects.push_back(std::make_unique<Surroundings>(temperature_c, nullptr, parameters.firmware_period_s));
  for (const twin::EffectSetting& effect : hypothesis.effects) effects.push_back(effect.info->make(effect.values));
  return {parameters, std::move(effects)};
}

}  // namespace

std::size_t commandsAfter(const Case& given, const Trajectory& log, std::size_t row) {
  return given.goal_order == GoalOrder::kAfterRead ? row : std::min(row + 1, log.rows() - 1);
}

double temperatureOf(const Trajectory& log, std::size_t row) {
  const double temperature = (log.warmth_c.empty() ? log.temp_c : log.warmth_c)[row];
  return std::isnan(temperature) ? twin::kRoomC : temperature;
}

FirmwareRun runFirmware(const Case& given, const Trajectory& log, const Hypothesis& hypothesis) {
  FirmwareRun run;
  run.period_s = hypothesis.servo.firmware_period_s;
  double temperature_c = temperatureOf(log, 0);
  twin::Servo servo = servoFor(hypothesis, temperature_c);
  const std::optional<double> held = heldBefore(log, given.goal_order);
  servo.reset(held.value_or(knownPosition(log, 0)), log.session_start_s);
  ServoDrive drive{.torque_limit = 1, .supply_v = supplyOf(given, log, hypothesis)};
  drive.speed_limit_rad_s = log.speed_limit_rad_s > 0 ? log.speed_limit_rad_s : std::numeric_limits<double>::infinity();
  const auto goal_at = [&](std::size_t commands) {
    const double goal = log.goal_rad[commands];
    if (given.goal_order == GoalOrder::kAfterRead || commands == 0) return goal;
    const double end_s = static_cast<double>(run.periods() + 1) * run.period_s;
    const double written_s = writtenAt(log, commands, hypothesis.written_before_s);
    const double share = shareOfGoal(end_s, written_s, run.period_s), before = log.goal_rad[commands - 1];
    return share < 1 ? std::lerp(before, goal, share) : goal;
  };
  const auto period = [&](std::size_t commands, double position, double velocity) {
    const bool is_before = run.duty.empty() && held && !log.isReadAfterWrite();
    drive.goal_rad = is_before ? *held : goal_at(commands);
    drive.torque_on = is_before || log.torque_on[commands] != 0;
    drive.p_gain = log.pRegisterAt(commands) / kRegisterPerKp;
    temperature_c = temperatureOf(log, commands);
    servo.firmware(drive, position, velocity);
    run.duty.push_back(servo.signals().duty);
    run.speed_rad_s.push_back(servo.signals().speed_command_rad_s);
    run.supply_v.push_back(servo.signals().supply_v);
    run.position_rad.push_back(position);
    run.row.push_back(commands);
  };
  // Periods of a row's reading in which the servo has the goals of that row already.
  const auto after_write = [&](std::size_t row) -> std::size_t {
    if (!log.isReadAfterWrite()) return 0;
    const auto periods = [&](double time_s) {
      return std::floor((log.time_s[row] - log.time_s[0] + time_s) / run.period_s + kInstant);
    };
    return static_cast<std::size_t>(std::max(1.0, periods(log.read_s[row]) - periods(log.written_s[row])));
  };
  period(0, knownPosition(log, 0), 0);
  // The integral at the end of the hold is unknown; the first load reading gives it, to its resolution of 1/1023.
  if (held && std::isfinite(log.load[0])) {
    servo.startIntegralFrom(log.load[0]);
    run.duty.back() = servo.signals().duty;
  }
  run.last.push_back(0);
  for (std::size_t row = 0; row + 1 < log.rows(); ++row) {
    const std::size_t commands = commandsAfter(given, log, row);
    const double from_s = log.time_s[row] - log.time_s[0], to_s = log.time_s[row + 1] - log.time_s[0];
    const double position = knownPosition(log, row);
    const double velocity = (knownPosition(log, row + 1) - position) / (to_s - from_s);
    for (double t = static_cast<double>(run.periods()) * run.period_s; t <= to_s + kInstant * run.period_s;
         t = static_cast<double>(run.periods()) * run.period_s) {
      const bool has_next = t + static_cast<double>(after_write(row + 1)) * run.period_s > to_s + kInstant;
      period(has_next ? row + 1 : commands, position + velocity * (t - from_s), velocity);
    }
    run.last.push_back(run.periods() - 1);
  }
  return run;
}

}  // namespace darwinop::gap
