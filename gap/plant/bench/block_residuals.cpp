#include "gap/plant/bench/block_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/plant/bench/firmware_run.hpp"
#include "gap/plant/registers.hpp"
#include "gap/plant/row_state.hpp"
#include "gap/plant/trace.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kUnknownSample = std::numeric_limits<double>::quiet_NaN();
const double kOfAStep = std::sqrt(1.0 / 12);        // standard deviation of rounding to steps of 1
constexpr double kRipple = Disturbance{}.supply_v;  // V

BlockResiduals samplesOf(const Trajectory& log) {
  const auto n = static_cast<Eigen::Index>(log.rows());
  BlockResiduals out;
  out.residual.setConstant(n, kUnknownSample);
  out.sigma.setOnes(n);
  out.z.setZero(n);
  out.row.resize(log.rows());
  for (std::size_t row = 0; row < log.rows(); ++row) out.row[row] = row;
  return out;
}

/// Position by a straight line between rows.
double positionAt(const Trajectory& log, std::size_t row, double time_s) {
  while (row > 0 && log.time_s[row - 1] >= time_s) --row;
  if (row == 0) return log.position_rad[0];
  const double share = (time_s - log.time_s[row - 1]) / (log.time_s[row] - log.time_s[row - 1]);
  return log.position_rad[row - 1] + share * (log.position_rad[row] - log.position_rad[row - 1]);
}

}  // namespace

BlockResiduals controllerResiduals(const Case& given, const Trajectory& log, const Hypothesis& hypothesis) {
  BlockResiduals out = samplesOf(log);
  if (!loadIsDutyIn(hypothesis, log)) return out;
  const FirmwareRun run = runFirmware(given, log, hypothesis);
  const double sigma = readingSigma(hypothesis.servo), load_step = loadStepOf(log);
  for (std::size_t row = 1; row < log.rows(); ++row) {
    const std::size_t commands = run.row[run.last[row]];
    if (log.torque_on[commands] == 0 || std::isnan(log.position_rad[row])) continue;
    const auto i = static_cast<Eigen::Index>(row);
    const double gain = hypothesis.servo.duty_per_kp_per_rad * log.pRegisterAt(commands);
    const double reading = std::hypot(gain * sigma, load_step * kOfAStep);
    out.residual[i] = log.load[row] - run.duty[run.last[row]];
    // The period of a load is known to one period only, and a row may be read late by as much.
    const double rate = (log.load[row] - log.load[row - 1]) / (log.time_s[row] - log.time_s[row - 1]);
    out.sigma[i] = std::hypot(reading, std::isnan(rate) ? 0 : rate * run.period_s * kOfAStep);
    // Within a row the goal has just been written, and a speed limit lets it act over several periods.
    if (log.isReadAfterWrite() && run.last[row] > 0)
      out.sigma[i] = std::hypot(out.sigma[i], run.duty[run.last[row]] - run.duty[run.last[row] - 1]);
  }
  return out;
}

BlockResiduals supplyResiduals(const Case& given, const Trajectory& log, const Hypothesis& hypothesis) {
  BlockResiduals out = samplesOf(log);
  const FirmwareRun run = runFirmware(given, log, hypothesis);
  for (std::size_t row = 0; row < log.rows(); ++row)
    out.residual[static_cast<Eigen::Index>(row)] = log.volt_v[row] - run.supply_v[run.last[row]];
  out.sigma.setConstant(std::hypot(kVoltStep * kOfAStep, kRipple));
  return out;
}

Eigen::VectorXd drawnCurrent(const Case& given, const Trajectory& log, const Hypothesis& hypothesis) {
  const twin::ServoParameters& servo = hypothesis.servo;
  const double supply_v = supplyOf(given, log, hypothesis);
  Eigen::VectorXd current(static_cast<Eigen::Index>(log.rows()));
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const double duty = log.torque_on[row] == 0 ? 0 : log.load[row];
    const double volt_v = std::isnan(log.volt_v[row]) ? supply_v : log.volt_v[row];
    const double motor = (duty * volt_v - servo.back_emf_vs_rad * stateAt(log, row).speed_rad_s) / servo.resistance_ohm;
    current[static_cast<Eigen::Index>(row)] = duty * motor;
  }
  return current;
}

double supplyResistance(const Case& given, const std::vector<const Trajectory*>& logs, const Hypothesis& hypothesis) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Trajectory* const log : logs) {
    const Eigen::VectorXd current = drawnCurrent(given, *log, hypothesis),
                          volt = supplyResiduals(given, *log, hypothesis).residual;
    for (Eigen::Index k = 0; k < current.size(); ++k) {
      if (std::isnan(current[k]) || std::isnan(volt[k])) continue;
      n += 1, x += current[k], y += volt[k], xx += current[k] * current[k], xy += current[k] * volt[k];
    }
  }
  const double spread = n * xx - x * x;
  return spread > 1e-9 ? -(n * xy - x * y) / spread : kUnknownSample;
}

BlockResiduals sensorResiduals(const Trajectory& log, const Hypothesis& hypothesis) {
  BlockResiduals out = samplesOf(log);
  // Begin and end, each read twice: by the servo for its speed, and by the host.
  const double reading = readingSigma(hypothesis.servo) * 2 / kSpeedSpan;
  for (std::size_t row = 2; row + 1 < log.rows(); ++row) {
    if (log.time_s[row] - log.time_s[0] < kSpeedSpan) continue;
    const auto i = static_cast<Eigen::Index>(row);
    const double moved = log.position_rad[row] - positionAt(log, row, log.time_s[row] - kSpeedSpan);
    if (std::isnan(moved)) continue;  // a masked position
    out.residual[i] = log.speed_rad_s[row] - moved / kSpeedSpan;
    const double before = stateAt(log, row - 1).speed_rad_s, after = stateAt(log, row + 1).speed_rad_s;
    const double accel = (after - before) / (log.time_s[row + 1] - log.time_s[row - 1]);
    out.sigma[i] =
        std::sqrt(reading * reading + kSpeedStep * kSpeedStep / 12 + std::pow(accel * thresholds::kSpeedLag, 2) +
                  std::pow(thresholds::kSpeedScale * moved / kSpeedSpan, 2));
  }
  return out;
}

}  // namespace darwinop::gap
