#include "gap/plan/experiment_text.hpp"

#include <algorithm>
#include <set>

#include "core/servo_limits.hpp"
#include "core/text/number_text.hpp"
#include "experiments/format/shape.hpp"

namespace darwinop::gap {
namespace {

using experiments::Phase;
using experiments::Shape;
using experiments::TorqueMode;

std::string listOf(const std::vector<double>& values, std::string_view unit) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ", ") + text::shortestText(value) + " " + std::string{unit};
  return text;
}

class Writer {
 public:
  void section(const std::string& name) { text += "\n[" + name + "]\n"; }
  void line(std::string key, const std::string& value) {
    constexpr std::size_t kColumn = 12;
    key.resize(std::max(kColumn, key.size()), ' ');
    text += key + " = " + value + "\n";
  }
  void line(std::string key, double value, std::string_view unit) {
    line(std::move(key),
         unit.empty() ? text::shortestText(value) : text::shortestText(value) + " " + std::string{unit});
  }
  std::string text;
};

void writeGoal(const Phase& phase, Writer& out) {
  const experiments::Goal& goal = phase.goal;
  out.line("goal", std::string{experiments::kShapeNames[static_cast<std::size_t>(goal.shape)]});
  switch (goal.shape) {
    case Shape::kHold:
      break;
    case Shape::kStep:
    case Shape::kRamp:
    case Shape::kMove:
      out.line("to", goal.to, "rad");
      break;
    case Shape::kSteps:
      out.line("goals", listOf(goal.goals, "rad"));
      out.line("every", listOf(goal.every_s, "s"));
      break;
    case Shape::kTriangle:
      out.line("amplitude", goal.amplitude, "rad");
      out.line("period", goal.period_s, "s");
      break;
    case Shape::kSine:
    case Shape::kChirp:
    case Shape::kMultisine:
      out.line("amplitude", goal.amplitude, "rad");
      out.line("frequency", listOf(goal.hz, "Hz"));
      break;
  }
}

void writeTorque(const Phase& phase, Writer& out) {
  const experiments::Slope& nm = phase.newton_meter;
  const std::string slope =
      text::shortestText(nm.begin) + " N m" + (nm.begin == nm.end ? "" : " to " + text::shortestText(nm.end) + " N m");
  if (phase.torque == TorqueMode::kOff) out.line("torque", "off");
  if (phase.torque == TorqueMode::kDirect) out.line("torque", slope);
  const experiments::Slope usual = Phase{}.newton_meter;
  if (phase.torque == TorqueMode::kLimit && (nm.begin != usual.begin || nm.end != usual.end))
    out.line("torque_limit", slope);
}

void writeEnd(const Phase& phase, Writer& out) {
  if (phase.until != experiments::Until::kTime)
    out.line("until", std::string{experiments::kUntilNames[static_cast<std::size_t>(phase.until)]});
  if (phase.until == experiments::Until::kArrival) {
    out.line("within", phase.within, "rad");
    if (phase.torque != TorqueMode::kLimit && phase.arrive_at) out.line("to", *phase.arrive_at, "rad");
  }
  out.line("duration", phase.duration_s, "s");
}

std::string signedName(const experiments::Moved& moved) {
  return (moved.sign < 0 ? "-" : "") + std::string{row(moved.joint).name};
}

void writePhase(const Phase& phase, const std::string& name, Writer& out) {
  out.section("phase " + name);
  std::string joints;
  for (const experiments::Moved& moved : phase.joints) joints += (joints.empty() ? "" : ", ") + signedName(moved);
  out.line("joints", phase.joints == experiments::allMoved() ? std::string{experiments::kAllJoints} : joints);
  if (phase.torque == TorqueMode::kLimit) writeGoal(phase, out);
  writeTorque(phase, out);
  if (experiments::jumps(phase.goal.shape) || phase.velocity != kFullSpeed)
    out.line("velocity", phase.velocity, "rad/s");
  if (phase.acceleration > 0) out.line("acceleration", phase.acceleration, "rad/s2");
  out.line("p_gain", phase.p_gain, "");
  writeEnd(phase, out);
}

/// Phases of several rounds in one file: every name once.
std::string freshName(const std::string& name, std::set<std::string>& taken) {
  std::string fresh = name;
  for (int i = 2; !taken.insert(fresh).second; ++i) fresh = name + "_" + std::to_string(i);
  return fresh;
}

}  // namespace

std::string experimentText(const experiments::Experiment& experiment, const std::vector<std::string>& comments) {
  Writer out;
  for (const std::string& comment : comments) out.text += "; " + comment + "\n";
  out.text += "[experiment]\n";
  out.line("name", experiment.name);
  out.line("title", experiment.title);
  if (!experiment.source.empty()) out.line("source", experiment.source);
  for (const std::string& line : experiment.description) out.line("description", line);

  const experiments::ExperimentSetup& setup = experiment.setup;
  out.section("setup");
  if (setup.is_clamped) out.line("trunk", "clamped");
  out.line("pose", std::string{setup.named->name});
  for (std::size_t i = 0; i < kJoints; ++i)
    if (setup.pose[i] != setup.named->pose[i]) out.line(std::string{kJointTable[i].name}, setup.pose[i], "rad");
  out.line("duration", setup.duration_s, "s");
  if (setup.settle_s > 0) out.line("settle", setup.settle_s, "s");

  std::set<std::string> taken;
  for (const experiments::Round& round : experiment.rounds) {
    if (!round.label.empty()) out.text += "\n; " + round.label + "\n";
    for (const Phase& phase : round.phases) writePhase(phase, freshName(phase.name, taken), out);
  }
  out.section("record");
  std::string joints;
  for (const Joint joint : experiment.record_joints)
    joints += (joints.empty() ? "" : ", ") + std::string{row(joint).name};
  out.line("joints", experiment.record_joints.size() == kJoints ? std::string{experiments::kAllJoints} : joints);
  std::string sensors;
  for (const std::string& sensor : experiment.record_sensors) sensors += (sensors.empty() ? "" : ", ") + sensor;
  if (!sensors.empty()) out.line("sensors", sensors);
  return std::move(out.text);
}

}  // namespace darwinop::gap
