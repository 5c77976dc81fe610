// Short simulations of the mechanics, each from a measured state. Never by differentiating positions: a duty that jumps
// between two rows would turn into torques that were never applied.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/conversions.hpp"
#include "gap/plant/bench/block_residuals.hpp"
#include "gap/plant/bench/firmware_run.hpp"
#include "gap/plant/bench/internal_effect.hpp"
#include "gap/plant/bench/surroundings.hpp"
#include "gap/plant/registers.hpp"
#include "gap/plant/row_state.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

const twin::EffectInfo kGivenDrive =
    internalEffect("given_drive", "what was measured drives the motor", twin::LoopPart::kController);

struct Drive {
  double duty = 0, speed_rad_s = 0, supply_v = 0;
};

/// Replaces the duty of the control law by a given one.
class GivenDrive final : public twin::Effect {
 public:
  explicit GivenDrive(const Drive& drive) : drive_{drive} {}
  [[nodiscard]] const twin::EffectInfo& info() const noexcept override { return kGivenDrive; }
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMotorHook; }
  void motor(twin::Signals& s, double /*dt_s*/) noexcept override {
    s.duty = drive_.duty;
    s.speed_command_rad_s = drive_.speed_rad_s;
  }

 private:
  const Drive& drive_;
};

/// The law's duty between the rows, offset to agree with the measured load at the rows.
std::vector<double> measuredDuty(const Trajectory& log, const FirmwareRun& run, double most) {
  std::vector<double> duty = run.duty;
  for (std::size_t row = 0; row + 1 < log.rows(); ++row) {
    const std::size_t from = run.last[row], to = run.last[row + 1];
    if (std::isnan(log.load[row]) || std::isnan(log.load[row + 1])) continue;
    const double before = log.load[row] - run.duty[from], after = log.load[row + 1] - run.duty[to];
    for (std::size_t i = from + 1; i <= to; ++i) {
      const double share = static_cast<double>(i - from) / static_cast<double>(to - from);
      if (log.torque_on[run.row[i]] != 0)
        duty[i] = std::clamp(run.duty[i] + before + share * (after - before), -most, most);
    }
  }
  return duty;
}

class Shooter {
 public:
  Shooter(const Case& given, const Trajectory& log, const Hypothesis& hypothesis, const ShootingOptions& options)
      : log_{log},
        options_{options},
        run_{runFirmware(given, log, hypothesis)},
        duty_{loadIsDutyIn(hypothesis, log) ? measuredDuty(log, run_, hypothesis.servo.duty_max) : run_.duty},
        nominal_v_{supplyOf(given, log, hypothesis)},
        temperature_c_{temperatureOf(log, 0)},
        bench_{servoOf(hypothesis), effects(hypothesis), armOf(given, log, hypothesis)} {}

  /// Measured - simulated position at row `to` when begun at row `from`.
  double residual(std::size_t from, std::size_t to) {
    const RowState state = stateAt(log_, from);
    const double begun_s = log_.time_s[from] - log_.time_s[0];
    temperature_c_ = temperatureOf(log_, from);
    bench_.reset({.steps_per_period = 2,
                  .start_rad = state.position_rad,
                  .start_rad_s = state.speed_rad_s,
                  .session_time_s = log_.session_start_s + begun_s});
    std::size_t next = from + 1;  // row that is read next
    for (std::size_t i = run_.last[from] + 1; i <= run_.last[to]; ++i) {
      while (run_.last[next] < i) ++next;
      const std::size_t row = run_.row[i];
      drive_ = {.duty = duty_[i], .speed_rad_s = run_.speed_rad_s[i], .supply_v = supplyAt(i, next)};
      temperature_c_ = temperatureOf(log_, row);
      bench_.step({.torque_on = log_.torque_on[row] != 0,
                   .goal_rad = log_.goal_rad[row],
                   .speed_limit_rad_s = std::numeric_limits<double>::infinity(),
                   .torque_limit = 1,
                   .p_gain = log_.p_register / kRegisterPerKp,
                   .supply_v = drive_.supply_v});
    }
    const double whole_s = static_cast<double>(run_.last[to] - run_.last[from]) * run_.period_s;
    const double rest_s = log_.time_s[to] - log_.time_s[from] - whole_s;
    return log_.position_rad[to] - bench_.encoder_rad() - bench_.velocity_rad_s() * rest_s;
  }

  [[nodiscard]] bool counts(std::size_t from, std::size_t to) const {
    bool on = false, off = false;
    for (std::size_t row = from; row <= to; ++row) (log_.torque_on[row] != 0 ? on : off) = true;
    if (on && off) return options_.mixed;
    return on ? options_.powered : options_.limp;
  }

 private:
  /// Between the reads of two rows on a straight line.
  [[nodiscard]] double supplyAt(std::size_t period, std::size_t next_row) const {
    const double before = lastReading(log_, log_.volt_v, "volt", next_row - 1),
                 after = lastReading(log_, log_.volt_v, "volt", next_row);
    if (!options_.measured_supply || std::isnan(before) || std::isnan(after)) return nominal_v_;
    const std::size_t from = run_.last[next_row - 1], to = run_.last[next_row];
    return before + (after - before) * static_cast<double>(period - from) / static_cast<double>(to - from);
  }

  static twin::ServoParameters servoOf(const Hypothesis& hypothesis) {
    twin::ServoParameters servo = hypothesis.servo;
    servo.ticks_per_rev = 1 << 26;
    servo.overload_time_s = std::numeric_limits<double>::infinity();
    return servo;
  }

  std::vector<std::unique_ptr<twin::Effect>> effects(const Hypothesis& hypothesis) {
    std::vector<std::unique_ptr<twin::Effect>> all;
    all.push_back(std::make_unique<Surroundings>(temperature_c_, nullptr, run_.period_s));
    all.push_back(std::make_unique<GivenDrive>(drive_));
    for (const twin::EffectSetting& effect : hypothesis.effects) {
      // The measured voltage has the sag in it.
      if (options_.measured_supply && effect.info->part == twin::LoopPart::kSupply) continue;
      all.push_back(effect.info->make(effect.values));
    }
    return all;
  }

  const Trajectory& log_;
  const ShootingOptions options_;
  const FirmwareRun run_;
  const std::vector<double> duty_;
  const double nominal_v_;
  double temperature_c_;
  Drive drive_;
  twin::Bench bench_;
};

}  // namespace

BlockResiduals shootingResiduals(const Case& given, const Trajectory& log, const Hypothesis& hypothesis,
                                 const ShootingOptions& options) {
  Shooter shooter{given, log, hypothesis, options};
  std::vector<double> residuals;
  BlockResiduals out;
  double next_s = log.time_s.front() + thresholds::kStateHalfWindow;
  for (std::size_t from = 0, to = 0; from < log.rows(); ++from) {
    if (log.time_s[from] < next_s) continue;
    next_s = log.time_s[from] + std::min(options.stride_s, options.length_s);
    while (to < log.rows() && log.time_s[to] < log.time_s[from] + options.length_s - 1e-9) ++to;
    if (to >= log.rows()) break;
    out.row.push_back((from + to) / 2);
    residuals.push_back(shooter.counts(from, to) ? shooter.residual(from, to)
                                                 : std::numeric_limits<double>::quiet_NaN());
  }
  const auto n = static_cast<Eigen::Index>(residuals.size());
  out.residual = Eigen::Map<const Eigen::VectorXd>(residuals.data(), n);
  out.sigma.setConstant(n, readingSigma(hypothesis.servo) * std::sqrt(1.5));  // begin and end
  out.z.setZero(n);
  return out;
}

}  // namespace darwinop::gap
