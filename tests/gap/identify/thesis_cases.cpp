// Measured by the bench that hides effects: another integrator and step than the finder's (gap/hide).
#include "gap/identify/thesis_cases.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/conversions.hpp"
#include "gap/benchmark/make/simulate_log.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap::thesis {
namespace {

using Goal = std::function<double(double time_s)>;

constexpr double kRowTime = 0.016;   // control and logging period of all experiments
constexpr double kRegisterPerP = 8;  // of the P gain (MX-28 manual)
constexpr double kPause = 4;         // between two logs; the thesis does not say

struct Log {
  std::string file, kind;
  double p = 4;  // the gain, not the register; 4 is what a servo starts with
  double seconds = 4;
  Goal goal_rad;
  double limp_from_s = 1e9;
  double speed_limit_rad_s = 0;
  double starts_at_rad = 0;  // of a case whose goals come before the read
};

// The arm hanging from the shoulder: upper arm 168 g, forearm and hand 59 g, whose middle is 130 mm from the axis.
constexpr twin::Pendulum kArm{.payload_kg = 0.059, .arm_mass_kg = 0.168, .length_m = 0.13};

void add(Log wanted, Case& c) {
  Trajectory log;
  log.file = wanted.file;
  log.kind = wanted.kind;
  log.held_out = wanted.file.starts_with("score");
  log.p_register = wanted.p * kRegisterPerP;
  log.payload_kg = c.pendulum.payload_kg;
  log.speed_limit_rad_s = wanted.speed_limit_rad_s;
  log.session_start_s = c.logs.empty() ? 1 : c.logs.back().session_start_s + c.logs.back().duration_s() + kPause;
  for (int row = 0; row * kRowTime < wanted.seconds; ++row) {
    const double t = row * kRowTime;
    log.time_s.push_back(t);
    log.goal_rad.push_back(std::round(wanted.goal_rad(t) / kRadPerTick) * kRadPerTick);
    log.torque_on.push_back(t < wanted.limp_from_s ? 1 : 0);
    log.lines.push_back(static_cast<std::uint32_t>(row) + 2);
  }
  log.position_rad.assign(log.rows(), wanted.starts_at_rad);
  c.logs.push_back(std::move(log));
}

/// The logs of the robot.
Case measured(const Case& model, const Hypothesis& robot, std::uint64_t seed) {
  CasePlan plan = planLike(model, model.name);
  for (std::size_t i = 0; i < plan.given.logs.size(); ++i) {
    Disturbance disturbance;
    disturbance.seed = seed * 100 + i;
    measure(plan, {.bench = robot, .outside = {}}, &disturbance, plan.given.logs[i]);
  }
  return plan.given;
}

double& valueOf(Hypothesis& robot, std::string_view effect, std::string_view key) {
  return gap::valueOf(robot.with(*twin::findEffect(effect)), key);
}

void believe(std::string_view effect, double value, std::string_view key, Case& c) {
  c.model.effects.push_back({.info = twin::findEffect(effect), .values = {value}, .joint = {}});
  c.priors.push_back({std::string{effect} + "." + std::string{key}, 0.1});
}

/// The simulator's motor: P = 1 is 1 rad/s per rad of error, any torque up to 2.5 N m.
Case simulator(const std::string& name) {
  Case c;
  c.name = c.model.name = name;
  c.model.servo.law = twin::Law::kSpeedP;
  c.model.servo.back_emf_vs_rad = c.model.servo.kt_nm_a;
  c.datasheet = Datasheet{.servo = c.model.servo, .relative_sigma = 0.05};
  c.datasheet->servo.law = twin::Law::kVoltageP;
  c.pendulum = kArm;
  c.priors = {{"payload", 0.01}, {"length", 0.01}, {"armature", 0.1}};
  return c;
}

/// The servo by its data sheet, with the friction of 5.3.2.
Case servo(const std::string& name) {
  Case c = simulator(name);
  c.model.servo.law = twin::Law::kVoltageP;
  c.priors.push_back({"kt", 0.02});
  c.priors.push_back({"resistance", 0.04});
  believe("coulomb", 0.025, "friction", c);
  believe("viscous", 0.002, "damping", c);
  return c;
}

/// From 0 to 1 in `seconds`, without a jerk at either end.
double eased(double t, double seconds) {
  return (1 - std::cos(kPi * std::clamp(t / seconds, 0.0, 1.0))) / 2;
}

}  // namespace

Case speedTest() {
  Case c = simulator("T1");
  // The head, 158 g, turns about an upright axis; its weight does nothing.
  c.pendulum = {.payload_kg = 0.158, .arm_mass_kg = 0, .length_m = 0.02};
  const auto sweeps = [&](const std::string& file, double speed) {
    const double half_s = kPi / speed + 0.7;
    const auto goal = [=](double t) { return std::fmod(t, 2 * half_s) < half_s ? kPi / 2 : -kPi / 2; };
    add({.file = file, .kind = "sweeps", .seconds = 3 * half_s, .goal_rad = goal, .speed_limit_rad_s = speed}, c);
  };
  sweeps("fit_1.csv", 2);
  sweeps("fit_2.csv", 4);
  sweeps("fit_3.csv", 8);
  sweeps("fit_4.csv", 12.2);
  sweeps("score_1.csv", 6);
  sweeps("score_2.csv", 10);
  Hypothesis robot = baselineOf(c);
  valueOf(robot, "accel_limit", "accel") = 55;
  return measured(c, robot, 1);
}

Case freeSwing() {
  Case c = simulator("T2");
  const auto released = [&](const std::string& file, double from_rad) {
    const auto goal = [=](double) { return from_rad; };
    add({.file = file, .kind = "release", .seconds = 6, .goal_rad = goal, .limp_from_s = 0.3}, c);
  };
  released("fit_1.csv", kPi / 2);
  released("fit_2.csv", -kPi / 2);
  released("fit_3.csv", kPi / 3);
  released("score_1.csv", kPi / 4);
  released("score_2.csv", -kPi / 3);
  Hypothesis robot = baselineOf(c);
  valueOf(robot, "coulomb", "friction") = 0.025;
  valueOf(robot, "viscous", "damping") = 0.002;
  return measured(c, robot, 2);
}

Case lowGainStep() {
  Case c = simulator("T3");
  // Of servo 3: from -0.8 rad, where the arm hangs (-0.785), to 0.8, where it stands out sideways.
  const auto raised = [&](const std::string& file, double p) {
    const auto goal = [](double t) { return t < 0.3 ? -0.015 : 1.585; };
    add({.file = file, .kind = "raise", .p = p, .seconds = 4, .goal_rad = goal}, c);
  };
  raised("fit_1.csv", 1);
  raised("fit_2.csv", 2);
  raised("fit_3.csv", 4);
  raised("score_1.csv", 3);
  Hypothesis robot = baselineOf(c);
  valueOf(robot, "p_on_torque", "on") = 1;
  return measured(c, robot, 3);
}

Case mirroredLoad() {
  Case c = servo("T4");
  const auto slow = [&](const std::string& file, double p) {
    const auto goal = [](double t) { return 1.585 * eased(t < 5 ? t : 10 - t, 5); };
    add({.file = file, .kind = "slow", .p = p, .seconds = 10, .goal_rad = goal}, c);
  };
  slow("fit_1.csv", 4);
  slow("fit_2.csv", 2);
  slow("score_1.csv", 3);
  Case mirrored = measured(c, baselineOf(c), 4);
  for (Trajectory& log : mirrored.logs)
    for (double& load : log.load) load = -load;
  return mirrored;
}

// With so low a gain that the goal's distance is a torque, which rises slowly, as in the thesis. The arm starts at rest
// as if it had come from below, and only rises: friction and weight both pull down all the time, and both by nearly the
// same everywhere.
Case risingArm() {
  constexpr double kFriction = 0.02;  // N m, hidden: "small resistances"
  constexpr double kFrom = 1.25;      // rad
  Case c = simulator("T7");
  c.model.servo.law = twin::Law::kVoltageP;
  c.priors.push_back({"kt", 0.02});
  c.priors.push_back({"resistance", 0.04});
  believe("viscous", 0.002, "damping", c);
  c.goal_order = GoalOrder::kBeforeRead;
  c.written_before_s = std::numeric_limits<double>::infinity();  // a simulator's controller: right after the last read
  const twin::ServoParameters& s = c.model.servo;
  const double weight_nm = (kArm.payload_kg + kArm.arm_mass_kg / 2) * kArm.length_m * kArm.gravity_m_s2;
  const auto rising = [&](const std::string& file, double p, double rad_s) {
    const double stiffness = s.kt_nm_a * s.supply_v / s.resistance_ohm * s.duty_per_kp_per_rad * p * kRegisterPerP;
    const double ahead_rad = (weight_nm * std::sin(kFrom) + kFriction) / stiffness;
    const auto goal = [=](double t) { return kFrom + ahead_rad + rad_s * t; };
    add({.file = file, .kind = "rise", .p = p, .seconds = 5, .goal_rad = goal, .starts_at_rad = kFrom}, c);
  };
  // Two curves, as in the thesis, each run once.
  rising("fit_1.csv", 0.25, 0.06);
  rising("fit_2.csv", 0.5, 0.06);
  rising("score_1.csv", 0.25, 0.05);
  Hypothesis robot = baselineOf(c);
  valueOf(robot, "coulomb", "friction") = kFriction;
  return measured(c, robot, 7);
}

Case kicks() {
  Case c = servo("T8");
  // Knee: shank, ankle and foot, 413 g.
  c.pendulum = {.payload_kg = 0.246, .arm_mass_kg = 0.167, .length_m = 0.093};
  // Two pages of one motion file, each for itself: draw back, kick, hold, put down.
  const auto kick = [&](const std::string& file, double side, double back_rad, double out_rad, double kick_s) {
    const auto goal = [=](double t) {
      return side * (0.3 - back_rad * eased(t - 0.4, 0.6) + (back_rad + out_rad) * eased(t - 1.2, kick_s) -
                     out_rad * eased(t - 1.9, 0.9));
    };
    add({.file = file, .kind = "kick", .seconds = 3.5, .goal_rad = goal}, c);
  };
  kick("fit_1.csv", 1, 0.62, 0.55, 0.16);
  kick("fit_2.csv", -1, 0.55, 0.63, 0.13);
  kick("fit_3.csv", 1, 0.55, 0.63, 0.13);
  kick("score_1.csv", -1, 0.62, 0.55, 0.16);
  return measured(c, baselineOf(c), 8);
}

}  // namespace darwinop::gap::thesis
