// Formats the plan of an experiment for users.
#include <algorithm>
#include <cmath>

#include "core/servo_limits.hpp"
#include "core/text/number_text.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/quantity.hpp"
#include "experiments/format/shape.hpp"

namespace darwinop::experiments {
namespace {

std::string angle(double rad) {
  return text::fixedText(rad, 3);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string motionOf(const JointPlan& joint) {
  std::string text =
      padded(std::string{row(joint.joint).name}, 10) + angle(joint.low) + " to " + angle(joint.high) + " rad";
  if (joint.fastest > 0) text += ", at most " + shortText(joint.fastest) + " rad/s";
  if (joint.loose) text += ", temporarily without a goal";
  return text;
}

/// Lists joints that move noticeably and counts the others.
std::string setupText(const Plan& plan) {
  constexpr double kNoticeable = 0.05;  // rad
  std::string text;
  std::size_t others = 0;
  for (const JointPlan& joint : plan.setup)
    if (std::abs(joint.high - joint.low) < kNoticeable)
      ++others;
    else
      text += "         " + motionOf(joint) + "\n";
  if (others > 0) text += "         " + std::to_string(others) + " joints by less than 0.05 rad\n";
  return text;
}

std::string slope(const Slope& value) {
  const std::string begin = shortText(value.begin);
  return (value.begin == value.end ? begin : begin + " to " + shortText(value.end)) + " N m";
}

std::string how(const Phase& phase) {
  std::string text;
  if (phase.torque == TorqueMode::kOff) text = "torque off";
  if (phase.torque == TorqueMode::kDirect) text = "torque " + slope(phase.newton_meter);
  if (phase.torque == TorqueMode::kLimit) {
    text = kShapeNames[static_cast<std::size_t>(phase.goal.shape)];
    if (phase.newton_meter.begin < kMaxTorqueNm || phase.newton_meter.end < kMaxTorqueNm)
      text += ", torque limit " + slope(phase.newton_meter);
    if (phase.p_gain != 4) text += ", P gain " + shortText(phase.p_gain);
  }
  text += ", " + std::string{phase.until == Until::kTime ? "" : "at most "} + shortText(phase.duration_s) + " s";
  if (phase.until != Until::kTime) text += ", until " + std::string{kUntilNames[static_cast<std::size_t>(phase.until)]};
  return text;
}

std::string falling(const Plan& plan) {
  if (plan.is_clamped) return messages::kClamped;
  if (plan.falls) return messages::kFalls;
  if (plan.on_feet) return messages::kOnFeet;
  return plan.legs ? messages::kLegsMayMove : messages::kOnKnees;
}

}  // namespace

std::string movedText(const Plan& plan) {
  std::string text;
  for (const JointPlan& joint : plan.moved)
    text += (text.empty() ? "" : ", ") + std::string{row(joint.joint).name} + " " + angle(joint.low) + " to " +
            angle(joint.high);
  return text + " rad";
}

std::string recordNotes(const Experiment& experiment) {
  std::string text = "experiment: " + experiment.name + "\ntitle: " + experiment.title + "\njoints:";
  for (const Joint joint : experiment.record_joints) text.append(" ").append(row(joint).name);
  if (!experiment.record_sensors.empty()) text += "\nsensors:";
  for (const std::string& sensor : experiment.record_sensors) text += " " + sensor;
  return text + "\n";
}

std::string planText(const Experiment& experiment, const Plan& plan) {
  std::string text = experiment.name + ": " + experiment.title;
  if (!experiment.source.empty()) text += " (" + experiment.source + ")";
  text += "\n  " + experiment.file + "\n";
  for (const std::string& line : experiment.description) text += "  " + line + "\n";
  text += "\nfirst    slowly from the start pose to '" + std::string{experiment.setup.named->name} + "', " +
          std::string{experiment.setup.named->what} + ", " + shortText(experiment.setup.duration_s) + " s\n";
  text += setupText(plan);
  text += "then     ";
  if (plan.rounds.size() > 1) {
    text += std::to_string(plan.rounds.size()) + " times, with";
    for (const RoundPlan& round : plan.rounds) text += (&round == plan.rounds.data() ? " " : "; ") + round.label;
    text += ", the last of them:\n         ";
  }
  for (const PhasePlan& phase : plan.rounds.back().phases)
    text += (&phase == plan.rounds.back().phases.data() ? "" : "         ") + padded(phase.phase->name, 9) + " " +
            how(*phase.phase) + "\n";
  text += "moves    ";
  for (const JointPlan& joint : plan.moved)
    text += (&joint == plan.moved.data() ? "" : "         ") + motionOf(joint) + "\n";
  text += "last     slowly back to the start pose, " + shortText(plan.back_s) + " s at most\n";
  text += "takes    " + shortText(plan.seconds()) + " s at most\n";
  text += "falls    " + falling(plan) + "\n";
  text += "records  ";
  for (const Joint joint : experiment.record_joints) text += std::string{row(joint).name} + " ";
  for (const std::string& sensor : experiment.record_sensors) text += sensor + " ";
  text.back() = '\n';
  return text;
}

}  // namespace darwinop::experiments
