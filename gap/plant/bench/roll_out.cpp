// Rows of a log and periods of a firmware run on two clocks: commands come with the rows, the servo acts every period.
#include "gap/plant/bench/roll_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>

#include "core/conversions.hpp"
#include "core/random.hpp"
#include "gap/plant/bench/firmware_run.hpp"
#include "gap/plant/bench/surroundings.hpp"
#include "gap/plant/row_state.hpp"
#include "gap/plant/write_instant.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kExactTicks = 1 << 26;  // a revolution: far below anything that shows

/// One log on one hypothesis.
class Run {
 public:
  Run(const Case& given, const Trajectory& log, const Hypothesis& hypothesis, const RollOutOptions& options)
      : given_{given},
        log_{log},
        options_{options},
        held_{heldBefore(log, given.goal_order)},
        is_written_between_{isWrittenBetween(given, log, hypothesis)},
        folded_{options.steps_per_period > 0 || is_written_between_ ? 1 : foldedPeriods(log, hypothesis)},
        period_s_{folded_ * hypothesis.servo.firmware_period_s},
        phase_s_{phaseOf(log, is_written_between_, options) * period_s_},
        nominal_v_{supplyOf(given, log, hypothesis)},
        written_before_s_{hypothesis.written_before_s},
        goal_rad_{held_.value_or(log.goal_rad[0])},
        temperature_c_{temperatureOf(log, 0)},
        bench_{servoOf(hypothesis), effects(hypothesis), armOf(given, log, hypothesis)} {
    if (options.disturbance != nullptr)
      ripple_.emplace(options.disturbance->supply_v, options.disturbance->supply_time_s, period_s_,
                      options.disturbance->seed * 2 + 1);
    drive_ = {.torque_on = held_.has_value() || log.torque_on[0] != 0,
              .goal_rad = goal_rad_,
              .speed_limit_rad_s =
                  log.speed_limit_rad_s > 0 ? log.speed_limit_rad_s : std::numeric_limits<double>::infinity(),
              .torque_limit = 1,
              .p_gain = log.p_register / kRegisterPerKp,
              .supply_v = nominal_v_};
    begin(hypothesis);
  }

  void fill(Trace& trace) {
    const std::size_t rows = log_.rows();
    trace.columns.resize(kJointSignals);
    for (std::vector<double>& column : trace.columns) column.resize(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      const double time_s = log_.time_s[row] - log_.time_s[0];
      if (log_.isReadAfterWrite()) {
        advanceTo(time_s + log_.written_s[row] + phase_s_);
        command(row);
        advanceTo(time_s + log_.read_s[row] + phase_s_);
        trace[kPositionSignal][row] = registered_rad_;
      } else if (is_written_between_) {
        commandBefore(row);
        advanceTo(time_s + phase_s_);
        trace[kPositionSignal][row] = registeredAt(time_s);
      } else {
        if (given_.goal_order == GoalOrder::kBeforeRead && row > 0) command(row);
        advanceTo(time_s);
        const double since_s = time_s - static_cast<double>(periods_) * period_s_;
        trace[kPositionSignal][row] = bench_.encoder_rad() + bench_.velocity_rad_s() * since_s;
      }
      trace[kSpeedSignal][row] = bench_.velocity_rad_s();
      trace[kLoadSignal][row] = loadNow();
      trace[kSupplySignal][row] = bench_.servo().signals().supply_v;
      if (!log_.isReadAfterWrite() && given_.goal_order == GoalOrder::kAfterRead) command(row);
    }
  }

 private:
  void begin(const Hypothesis& hypothesis) {
    bench_.reset({.steps_per_period = stepsFor(hypothesis),
                  .start_rad = startRad(hypothesis),
                  .goal_rad = held_,
                  .session_time_s = log_.session_start_s - (held_ ? kHeldBefore : 0),
                  .is_settled = true});
    registered_rad_ = bench_.encoder_rad();
    if (held_)
      for (long i = std::lround(kHeldBefore / period_s_); i > 0; --i) step();
  }

  // Where the joint was measured, not where its goal is: friction may hold it anywhere near, by a force that no log
  // shows. A joint that the hypothesis cannot hold there moves to where it rests. Commands alone: at the goal.
  [[nodiscard]] double startRad(const Hypothesis& hypothesis) const {
    const double tick = 2 * kPi / hypothesis.servo.ticks_per_rev;
    // A limp joint moves from its first reading on.
    const double measured = drive_.torque_on ? restBefore(log_, 1.5 * tick) : knownPosition(log_, 0);
    if (std::isnan(measured)) return drive_.goal_rad;
    if (options_.disturbance == nullptr) return measured;
    return measured +
           tick * (Rng{~options_.disturbance->seed}.uniform() - 0.5);  // the mean of readings leaves rounding
  }

  // The duty is constant over a period, so the midpoint is accurate to second order. A motor that takes any speed at
  // once needs a separate step for its jump, except with a soft gear.
  [[nodiscard]] int stepsFor(const Hypothesis& hypothesis) const {
    if (options_.steps_per_period > 0) return options_.steps_per_period;
    const bool soft = hypothesis.has(twin::StepDemand::kSoftGear);
    if (hypothesis.law() == twin::Law::kSpeedP) return soft ? 6 : 2;
    return soft ? 2 : 1;
  }

  /// Periods of a fine firmware that are simulated as one: the most that end with every row of the log.
  static int foldedPeriods(const Trajectory& log, const Hypothesis& hypothesis) {
    if (hypothesis.has(twin::StepDemand::kEveryPeriod) || log.isReadAfterWrite()) return 1;
    constexpr double kRounding = 1e-3;  // of a period; times in a log are rounded decimals
    const double period_s = hypothesis.servo.firmware_period_s;
    int most = static_cast<int>(thresholds::kLongestFold / period_s + kRounding);
    const auto fits = [&](int periods) {
      return std::ranges::all_of(log.time_s, [&](double time_s) {
        const double count = (time_s - log.time_s[0]) / (periods * period_s);
        return std::abs(count - std::round(count)) < kRounding;
      });
    };
    while (most > 1 && !fits(most)) --most;
    return std::max(1, most);
  }

  /// By what share of a period the firmware is ahead of the rows: a firmware that runs on its own is as old as its
  /// period when it is read, by chance.
  static double phaseOf(const Trajectory& log, bool is_written_between, const RollOutOptions& options) {
    if (is_written_between && options.disturbance == nullptr) return 0;  // the mean: shareOfGoal()
    if (log.is_phase_known && !is_written_between) return 0;
    return options.disturbance == nullptr ? kMeanPhase : Rng{splitMix(options.disturbance->seed)}.uniform();
  }

  /// The duty of a folded period is the mean of those it stands for: that of a position this much later.
  [[nodiscard]] double aheadS() const { return period_s_ * (1 - 1.0 / folded_) / 2; }

  void advanceTo(double time_s) {
    constexpr double kSameInstant = 1e-6;  // of a period
    while (static_cast<double>(periods_ + 1) <= time_s / period_s_ + kSameInstant) {
      step();
      ++periods_;
    }
  }

  /// That of the last of the periods that the simulated one stands for.
  [[nodiscard]] double loadNow() const {
    const double load = bench_.servo().report().load, most = bench_.servo().signals().duty_limit;
    const bool jumped =
        std::abs(load - load_before_) > thresholds::kFoldedLoadJump;  // a goal that came late, a torque that came on
    return jumped ? load : std::clamp(load + (load - load_before_) * aheadS() / period_s_, -most, most);
  }

  void step() {
    load_before_ = bench_.servo().report().load;
    registered_rad_ = bench_.encoder_rad();
    if (ripple_) drive_.supply_v = nominal_v_ + ripple_->next();
    const double share = shareOfGoal(static_cast<double>(periods_ + 1) * period_s_, written_s_, period_s_);
    drive_.goal_rad = share < 1 ? std::lerp(goal_before_rad_, goal_rad_, share) : goal_rad_;
    bench_.step(drive_);
  }

  void commandBefore(std::size_t row) {
    const double written_s = writtenAt(log_, row, written_before_s_);
    advanceTo(written_s + phase_s_);
    goal_before_rad_ = goal_rad_;
    if (options_.disturbance == nullptr) written_s_ = written_s;
    command(row);
  }

  // Read from one firmware of the many: what it registered a period ago. Of all of them: their mean.
  [[nodiscard]] double registeredAt(double time_s) const {
    if (options_.disturbance != nullptr) return registered_rad_;
    const double since = time_s / period_s_ - static_cast<double>(periods_);
    return std::lerp(registered_rad_, bench_.encoder_rad(), since);
  }

  void command(std::size_t row) {
    goal_rad_ = log_.goal_rad[row];
    drive_.torque_on = log_.torque_on[row] != 0;
    temperature_c_ = temperatureOf(log_, row);
  }

  [[nodiscard]] twin::ServoParameters servoOf(const Hypothesis& hypothesis) const {
    twin::ServoParameters servo = hypothesis.servo;
    servo.firmware_period_s = period_s_;
    if (options_.disturbance == nullptr || !given_.quantised) servo.ticks_per_rev = kExactTicks;
    servo.overload_time_s = std::numeric_limits<double>::infinity();  // the log records when the torque is off
    return servo;
  }

  [[nodiscard]] std::vector<std::unique_ptr<twin::Effect>> effects(const Hypothesis& hypothesis) const {
    std::vector<std::unique_ptr<twin::Effect>> all;
    all.push_back(std::make_unique<Surroundings>(temperature_c_, options_.disturbance, period_s_, aheadS()));
    for (const twin::EffectSetting& effect : hypothesis.effects) all.push_back(effect.info->make(effect.values));
    return all;
  }

  const Case& given_;
  const Trajectory& log_;
  const RollOutOptions options_;
  const std::optional<double> held_;  // goal before the first row
  const bool is_written_between_;
  const int folded_;  // periods of the firmware in one of the simulation
  const double period_s_, phase_s_, nominal_v_, written_before_s_;
  double goal_rad_, goal_before_rad_ = 0;  // written last, and before that
  double written_s_ = -std::numeric_limits<double>::infinity();
  double temperature_c_;
  twin::Bench bench_;
  std::optional<GaussMarkov> ripple_;
  ServoDrive drive_;
  double load_before_ = 0;     // of the period before
  double registered_rad_ = 0;  // position that the firmware read last
  long periods_ = 0;
};

void roundAsRegistersDo(const Disturbance& disturbance, double ticks_per_rev, Trace& trace) {
  std::mt19937_64 random{disturbance.seed * 2 + 2};
  std::normal_distribution<double> normal;
  const double tick = 2 * kPi / ticks_per_rev;
  for (double& position : trace[kPositionSignal])
    position = std::round(position / tick + disturbance.encoder_ticks * normal(random)) * tick;
}

}  // namespace

void rollOut(const Case& given, std::size_t log, const Hypothesis& hypothesis, const RollOutOptions& options,
             Trace& trace) {
  Run{given, given.logs[log], hypothesis, options}.fill(trace);
  if (options.disturbance != nullptr) roundAsRegistersDo(*options.disturbance, hypothesis.servo.ticks_per_rev, trace);
}

}  // namespace darwinop::gap
