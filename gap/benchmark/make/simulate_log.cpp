#include "gap/benchmark/make/simulate_log.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/conversions.hpp"
#include "gap/benchmark/make/rigid_arm.hpp"
#include "gap/plant/bench/roll_out.hpp"
#include "gap/plant/bench/surroundings.hpp"
#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

constexpr int kSoftSteps = 8;  // mechanical steps in a firmware period
constexpr double kFineTicks = 1 << 26;
constexpr double kTempStep = 1;  // degC, of the register

/// All effects of the true bench: noise and temperature first, effects outside the catalogue last.
std::vector<std::unique_ptr<twin::Effect>> effectsOf(const Truth& truth, std::unique_ptr<twin::Effect> surroundings,
                                                     const twin::Pendulum& arm) {
  std::vector<std::unique_ptr<twin::Effect>> all;
  all.push_back(std::move(surroundings));
  for (const twin::EffectSetting& effect : truth.bench.effects) all.push_back(effect.info->make(effect.values));
  for (const OutsideSetting& outside : truth.outside) all.push_back(outside.info->make(outside.values, arm));
  return all;
}

/// One log on a bench of either kind.
template <class Arm>
class Session {
 public:
  Session(const CasePlan& plan, const Truth& truth, const Disturbance* disturbance, Trajectory& log)
      : plan_{plan},
        log_{log},
        period_s_{truth.bench.servo.firmware_period_s},
        supply_v_{truth.bench.servo.supply_v},
        arm_{servoOf(plan, truth), effects(truth, disturbance), pendulumOf(truth, log)} {
    if (disturbance != nullptr)
      ripple_.emplace(disturbance->supply_v, disturbance->supply_time_s, period_s_, ~disturbance->seed);
    drive_.speed_limit_rad_s =
        log.speed_limit_rad_s > 0 ? log.speed_limit_rad_s : std::numeric_limits<double>::infinity();
    drive_.torque_limit = 1;
    drive_.p_gain = log.p_register * kGainPerCount;
    drive_.supply_v = supply_v_;
    command(0);
    const bool held = plan.given.goal_order == GoalOrder::kAfterRead && drive_.torque_on;
    const double before_s = held ? kHeldBefore : 0;
    session_s_ = log.session_start_s - before_s;
    temperature_c_ = plan.warmth.at(session_s_);
    arm_.reset({.steps_per_period = kSoftSteps,
                .start_rad = held ? log.goal_rad[0] : log.position_rad[0],
                .session_time_s = session_s_,
                .is_settled = true});
    for (long i = std::lround(before_s / period_s_); i > 0; --i) step();
  }

  void run() {
    const std::size_t rows = log_.rows();
    long done = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      const long due = std::lround((log_.time_s[row] - log_.time_s[0]) / period_s_);
      for (; done < due; ++done) step();
      read(row);
      const std::size_t next = plan_.given.goal_order == GoalOrder::kAfterRead ? row : std::min(row + 1, rows - 1);
      command(next);
    }
  }

 private:
  static twin::ServoParameters servoOf(const CasePlan& plan, const Truth& truth) {
    twin::ServoParameters servo = truth.bench.servo;
    if (!plan.given.quantised) servo.ticks_per_rev = kFineTicks;
    servo.overload_time_s = std::numeric_limits<double>::infinity();
    return servo;
  }
  static twin::Pendulum pendulumOf(const Truth& truth, const Trajectory& log) {
    twin::Pendulum pendulum = truth.bench.pendulum;
    pendulum.payload_kg = log.payload_kg * truth.bench.payload_scale;
    return pendulum;
  }
  std::vector<std::unique_ptr<twin::Effect>> effects(const Truth& truth, const Disturbance* disturbance) const {
    return effectsOf(truth, std::make_unique<Surroundings>(temperature_c_, disturbance, period_s_),
                     pendulumOf(truth, log_));
  }

  void step() {
    session_s_ += period_s_;
    temperature_c_ = plan_.warmth.at(session_s_);
    if (ripple_) drive_.supply_v = supply_v_ + ripple_->next();
    arm_.step(drive_);
  }
  void command(std::size_t row) {
    drive_.goal_rad = log_.goal_rad[row];
    drive_.torque_on = log_.torque_on[row] != 0;
  }
  void read(std::size_t row) {
    const JointMotion reading = arm_.servo().report();
    log_.position_rad[row] = arm_.encoder_rad();
    log_.speed_rad_s[row] = reading.velocity_rad_s;
    log_.load[row] = reading.load;
    log_.volt_v[row] = reading.supply_v;
    log_.temp_c[row] = temperature_c_;
  }

  const CasePlan& plan_;
  Trajectory& log_;
  double period_s_, supply_v_, session_s_ = 0, temperature_c_ = twin::kRoomC;
  Arm arm_;
  std::optional<GaussMarkov> ripple_;
  ServoDrive drive_;
};

void roundTo(double unit, std::vector<double>& column) {
  for (double& value : column) value = std::round(value / unit) * unit;
}

void roundColumns(const Disturbance& disturbance, double ticks_per_rev, Trajectory& log) {
  Rng rng{disturbance.seed};
  const double tick = 2 * kPi / ticks_per_rev;
  for (double& position : log.position_rad) position += disturbance.encoder_ticks * tick * rng.normal();
  roundTo(tick, log.position_rad);
  roundTo(kRadPerSecPerCount, log.speed_rad_s);
  roundTo(kLoadStep, log.load);
  roundTo(kVoltStep, log.volt_v);
  roundTo(kTempStep, log.temp_c);
}

}  // namespace

void measure(const CasePlan& plan, const Truth& truth, const Disturbance* disturbance, Trajectory& log) {
  if (truth.bench.has(twin::StepDemand::kSoftGear))
    Session<twin::Bench>{plan, truth, disturbance, log}.run();
  else
    Session<RigidArm>{plan, truth, disturbance, log}.run();
  if (disturbance != nullptr) roundColumns(*disturbance, plan.given.model.servo.ticks_per_rev, log);
}

}  // namespace darwinop::gap
