// One row an experiment; angles count from where the arm hangs.
#include "gap/plan/bench_experiments.hpp"

#include <string>

namespace darwinop::gap {
namespace {

using experiments::Phase;
using experiments::Round;
using experiments::Shape;

/// Makes the phases of one round.
class Script {
 public:
  Script(const ArmSetup& stand, double p_gain) : stand_{stand}, p_gain_{p_gain} {}

  Script& move(double to, double seconds) { return goTo("move", Shape::kMove, to, seconds); }
  Script& ramp(double to, double seconds) { return goTo("ramp", Shape::kRamp, to, seconds); }
  Script& hold(double seconds) { return drive("hold", {}, seconds); }
  Script& triangle(double amplitude, double period, double turns = 1) {
    experiments::Goal goal;
    goal.shape = Shape::kTriangle;
    goal.amplitude = amplitude;
    goal.period_s = period;
    return drive("swing", std::move(goal), turns * period);
  }
  Script& sine(double amplitude, double hz, double seconds) {
    experiments::Goal goal;
    goal.shape = Shape::kSine;
    goal.amplitude = amplitude;
    goal.hz = {hz};
    return drive("swing", std::move(goal), seconds);
  }
  Script& steps(const std::vector<double>& angles, double every) {
    experiments::Goal goal;
    goal.shape = Shape::kSteps;
    for (const double angle : angles) goal.goals.push_back(stand_.hangs_at_rad + angle);
    goal.every_s = {every};
    return drive("jump", std::move(goal), every * static_cast<double>(angles.size()));
  }
  Script& torqueOff(double seconds) {
    drive("limp", {}, seconds);
    round_.phases.back().torque = experiments::TorqueMode::kOff;
    return *this;
  }
  Round round() { return std::move(round_); }

 private:
  Script& goTo(std::string name, Shape shape, double angle, double seconds) {
    experiments::Goal goal;
    goal.shape = shape;
    goal.to = stand_.hangs_at_rad + angle;
    return drive(std::move(name), std::move(goal), seconds);
  }
  Script& drive(std::string name, experiments::Goal goal, double seconds) {
    Phase phase;
    phase.name = std::move(name);
    phase.joints = {{stand_.joint, 1}};
    phase.goal = std::move(goal);
    phase.duration_s = seconds;
    phase.p_gain = p_gain_;
    round_.phases.push_back(std::move(phase));
    return *this;
  }

  const ArmSetup& stand_;
  double p_gain_;
  Round round_;
};

std::vector<Round> triangleTwoGains(const ArmSetup& s, double p) {
  return {Script{s, p}.move(0, 1).triangle(0.9, 10).round(), Script{s, p / 4}.move(0, 1).triangle(0.9, 10).round()};
}
std::vector<Round> triangleThreeSpeeds(const ArmSetup& s, double p) {  // 0.05, 0.2 and 1 rad/s
  return {Script{s, p}.move(0, 1).triangle(0.25, 20).triangle(0.25, 5).triangle(0.25, 1, 2).round()};
}
std::vector<Round> triangleOneSide(const ArmSetup& s, double p) {
  return {Script{s, p}.move(0.7, 1).triangle(0.5, 8).round()};
}
std::vector<Round> stepsThreeSizes(const ArmSetup& s, double p) {
  return {Script{s, p}.steps({0, 0.2, 0, 0.6, 0, 1.2, 0}, 0.8).round()};
}
std::vector<Round> stepsThreeGains(const ArmSetup& s, double p) {
  std::vector<Round> rounds;
  for (const double p_gain : {p / 4, p / 2, p})
    rounds.push_back(Script{s, p_gain}.steps({0, 0.9, 0.3, -0.9, 0}, 0.9).round());
  return rounds;
}
std::vector<Round> holdsBothSides(const ArmSetup& s, double p) {
  Script script{s, p};
  for (const double angle : {-1.5, -0.8, 0.0, 0.8, 1.5}) script.move(angle, 0.8).hold(0.8);
  return {script.round()};
}
std::vector<Round> holdOnce(const ArmSetup& s, double p) {
  return {Script{s, p}.move(1, 1).hold(1).round()};
}
std::vector<Round> holdLong(const ArmSetup& s, double p) {
  return {Script{s, p}.move(1, 1).hold(5).round()};
}
std::vector<Round> holdFromBothSides(const ArmSetup& s, double p) {
  return {Script{s, p}.move(0.4, 0.8).move(0.9, 0.5).hold(1).move(1.4, 0.5).move(0.9, 0.5).hold(1).round()};
}
std::vector<Round> swingThreeHeights(const ArmSetup& s, double p) {
  std::vector<Round> rounds;
  for (const double angle : {0.5, 1.0, 1.5})
    rounds.push_back(Script{s, p}.move(angle, 1).hold(0.3).torqueOff(4).round());
  return rounds;
}
std::vector<Round> smallSines(const ArmSetup& s, double p) {
  return {Script{s, p}.move(0, 0.5).sine(0.05, 1, 3).move(1.05, 1).sine(0.05, 1, 3).round()};
}
std::vector<Round> constantSpeed(const ArmSetup& s, double p) {
  return {Script{s, p}.move(-1.2, 1).ramp(1.2, 2.4).ramp(-1.2, 2.4).ramp(1.2, 0.8).ramp(-1.2, 0.8).round()};
}
std::vector<Round> longSteps(const ArmSetup& s, double p) {
  return {Script{s, p}.steps({0, 1.4, -1.4, 1.4, 0}, 1).round()};
}

struct BenchRow {
  std::string_view name, title;
  std::vector<Round> (*rounds)(const ArmSetup&, double p_gain);
};
constexpr BenchRow kBench[]{
    {"triangle_two_gains", "Slow triangle both ways, at two P gains", triangleTwoGains},
    {"triangle_three_speeds", "Triangle around hanging at 0.05, 0.2 and 1 rad/s", triangleThreeSpeeds},
    {"triangle_one_side", "Slow triangle on one side of hanging", triangleOneSide},
    {"steps_three_sizes", "Steps of three sizes, there and back", stepsThreeSizes},
    {"steps_three_gains", "The same steps at three P gains", stepsThreeGains},
    {"holds_both_sides", "Holds at five angles on both sides of hanging", holdsBothSides},
    {"hold_once", "One hold on one side", holdOnce},
    {"hold_long", "One hold of five seconds under load", holdLong},
    {"hold_from_both_sides", "The same hold approached from below and from above", holdFromBothSides},
    {"swing_three_heights", "Torque off at three heights: the arm swings freely", swingThreeHeights},
    {"small_sines", "Small sine around hanging and around 60 degrees", smallSines},
    {"constant_speed", "Constant speed both ways, 1 and 3 rad/s", constantSpeed},
    {"long_steps", "Long steps from side to side at full speed", longSteps},
};

}  // namespace

std::vector<experiments::Experiment> benchExperiments(const ArmSetup& stand, double p_gain) {
  std::vector<experiments::Experiment> all;
  for (const BenchRow& row : kBench) {
    experiments::Experiment experiment;
    experiment.name = experiment.file = row.name;
    experiment.title = row.title;
    experiment.source = "darwinop gap plan";
    experiment.setup = stand.setup;
    experiment.rounds = row.rounds(stand, p_gain);
    experiment.record_joints = {stand.joint};
    all.push_back(std::move(experiment));
  }
  return all;
}

}  // namespace darwinop::gap
