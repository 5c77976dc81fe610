// Computes range, speed and duration of every joint before a run, and checks them against the limits.
#include "experiments/format/plan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text/ini_text.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/format/quantity.hpp"
#include "experiments/format/shape.hpp"

namespace darwinop::experiments {
namespace {

constexpr double kTolerance = 1e-4;       // rad: accepts a limit written with four digits
constexpr double kSample = 0.004;         // s, a quarter of the command period
constexpr double kMaxDuration = 30 * 60;  // s per run: servos heat up

/// Range of a joint's goal at the start of a phase.
struct StartRange {
  double low = 0, high = 0;
  [[nodiscard]] bool certain() const { return low == high; }
};

class Planner {
 public:
  Planner(const Experiment& experiment, const Ranges& ranges) : experiment_{experiment}, ranges_{ranges} {}

  Plan make() {
    planSetup();
    for (const Round& round : experiment_.rounds) {
      RoundPlan& out = plan_.rounds.emplace_back(RoundPlan{round.label, {}});
      for (const Phase& phase : round.phases) out.phases.push_back(planPhase(phase));
    }
    planReturn();
    if (plan_.seconds() > kMaxDuration)
      fail(experiment_.setup.line, "the experiment could take " + shortText(plan_.seconds()) + " s; at most " +
                                       shortText(kMaxDuration) + " s are allowed, because servos heat up");
    return std::move(plan_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw std::runtime_error(text::where(experiment_.file, line) + ": " + message);
  }
  [[noreturn]] void fail(const Phase& phase, const std::string& message) const {
    fail(phase.goal_line, "[phase " + phase.name + "] " + message);
  }

  /// Error message; empty if `goal` is within the joint's range.
  [[nodiscard]] std::string outside(Joint joint, double goal) const {
    const safety::JointRange& range = ranges_[index(joint)];
    if (goal >= range.low.value - kTolerance && goal <= range.high.value + kTolerance) return {};
    return "would send " + std::string{row(joint).name} + " to " + shortText(goal) + " rad; its limits are " +
           shortText(range.low.value) + " to " + shortText(range.high.value) + " rad";
  }

  void planSetup() {
    const ExperimentSetup& setup = experiment_.setup;
    plan_.is_clamped = setup.is_clamped;
    plan_.on_feet = setup.named->on_feet && !setup.is_clamped;
    plan_.setup_s = setup.duration_s + setup.settle_s;
    for (std::size_t i = 0; i < kJoints; ++i) {
      const auto joint = static_cast<Joint>(i);
      const double from = startPose()[i], to = setup.pose[i],
                   fastest = kSteepest * std::abs(to - from) / setup.duration_s;
      const int line = setup.line_of[i] != 0 ? setup.line_of[i] : setup.line;
      where_[i] = {to, to};
      if (const std::string wrong = outside(joint, to); !wrong.empty()) fail(line, "[setup] " + wrong);
      if (fastest > kSetupMost)
        fail(line, "[setup] would move " + std::string{row(joint).name} + " at " + shortText(fastest) +
                       " rad/s; at most " + shortText(kSetupMost) + " rad/s are allowed: set a duration of at least " +
                       shortText(std::ceil(kSteepest * std::abs(to - from) / kSetupMost * 10) / 10) + " s");
      if (std::abs(to - from) > kTolerance) plan_.setup.push_back({joint, from, to, fastest, false});
    }
  }

  PhasePlan planPhase(const Phase& phase) {
    PhasePlan out{&phase, {}};
    plan_.phases_s += phase.duration_s;
    plan_.falls = plan_.falls || phase.until == Until::kFallen;
    for (const Moved& moved : phase.joints) {
      out.joints.push_back(phase.torque == TorqueMode::kLimit ? planGoal(phase, moved) : planWithoutGoal(moved));
      merge(out.joints.back());
      plan_.legs = plan_.legs || isLeg(moved.joint);
    }
    return out;
  }

  JointPlan planWithoutGoal(const Moved& moved) {
    const safety::JointRange& range = ranges_[index(moved.joint)];
    where_[index(moved.joint)] = {range.low.value, range.high.value};
    return {moved.joint, range.low.value, range.high.value, 0, true};
  }

  JointPlan planGoal(const Phase& phase, const Moved& moved) {
    StartRange& where = where_[index(moved.joint)];
    const std::string name{row(moved.joint).name};
    if (swings(phase.goal.shape) && !where.certain())
      fail(phase, "oscillates around the position of " + name +
                      " at its start, which is not known: " + messages::kAddMoveBefore);
    JointPlan out{moved.joint, where.low, where.high, 0, false};
    if (jumps(phase.goal.shape)) out.fastest = phase.velocity;
    sample(phase, moved.sign, where.low, out);
    if (!where.certain()) sample(phase, moved.sign, where.high, out);
    for (const double goal : {out.low, out.high})
      if (const std::string wrong = outside(moved.joint, goal); !wrong.empty()) fail(phase, wrong);
    if (where.certain() && out.fastest > phase.velocity + 1e-6)
      fail(phase, "would move " + name + " at " + shortText(out.fastest) + " rad/s; its velocity is limited to " +
                      shortText(phase.velocity) + " rad/s");
    out.fastest = std::min(out.fastest, phase.velocity);
    where = after(phase, moved, where, out);
    return out;
  }

  static void sample(const Phase& phase, double sign, double begin, JointPlan& out) {
    double last = goalAt(phase.goal, phase.duration_s, sign, begin, 0);
    for (int i = 0; (i - 1) * kSample < phase.duration_s; ++i) {
      const double goal = goalAt(phase.goal, phase.duration_s, sign, begin, i * kSample);
      out.low = std::min(out.low, goal);
      out.high = std::max(out.high, goal);
      if (!jumps(phase.goal.shape)) out.fastest = std::max(out.fastest, std::abs(goal - last) / kSample);
      last = goal;
    }
  }

  static StartRange after(const Phase& phase, const Moved& moved, const StartRange& before, const JointPlan& goals) {
    if (phase.goal.shape == Shape::kHold) return before;
    if (phase.until != Until::kTime && phase.goal.shape != Shape::kStep) return {goals.low, goals.high};
    const double end = goalAt(phase.goal, phase.duration_s, moved.sign, before.low, phase.duration_s);
    return {end, end};
  }

  void merge(const JointPlan& joint) {
    const auto found = std::ranges::find(plan_.moved, joint.joint, &JointPlan::joint);
    if (found == plan_.moved.end()) return plan_.moved.push_back(joint);
    found->low = std::min(found->low, joint.low);
    found->high = std::max(found->high, joint.high);
    found->fastest = std::max(found->fastest, joint.fastest);
    found->loose = found->loose || joint.loose;
  }

  void planReturn() {
    double distance = 0;
    for (const JointPlan& joint : plan_.moved) {
      const double pose = experiment_.setup.pose[index(joint.joint)];
      distance = std::max({distance, std::abs(joint.low - pose), std::abs(joint.high - pose)});
    }
    plan_.back_s = slowTime(distance) + experiment_.setup.duration_s;
  }

  const Experiment& experiment_;
  const Ranges& ranges_;
  std::array<StartRange, kJoints> where_{};
  Plan plan_;
};

}  // namespace

double slowTime(double distance_rad) {
  return std::max(0.5, kSteepest * distance_rad / kSlow);
}

Plan makePlan(const Experiment& experiment, const Ranges& ranges) {
  return Planner{experiment, ranges}.make();
}

}  // namespace darwinop::experiments
