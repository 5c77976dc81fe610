// Parses a section [phase NAME].
#include "experiments/format/phase_reader.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/text/ini_text.hpp"
#include "core/text/joined.hpp"
#include "experiments/format/quantity.hpp"

namespace darwinop::experiments {
namespace {

using Words = std::vector<std::string_view>;

/// Required keys of each shape.
Words keysOf(Shape shape) {
  switch (shape) {
    case Shape::kHold:
      return {};
    case Shape::kStep:
      return {"to", "velocity"};
    case Shape::kSteps:
      return {"goals", "every", "velocity"};
    case Shape::kRamp:
    case Shape::kMove:
      return {"to"};
    case Shape::kTriangle:
      return {"amplitude", "period"};
    default:
      return {"amplitude", "frequency"};
  }
}

template <class Enum, std::size_t size>
Enum choice(std::string_view text, const std::array<std::string_view, size>& names) {
  const auto found = std::ranges::find(names, text);
  const Words all{names.begin(), names.end()};
  if (found == names.end())
    throw std::runtime_error("'" + std::string{text} + "' is not allowed here" + didYouMean(text, all) +
                             "; choose one of " + text::joined(all));
  return static_cast<Enum>(found - names.begin());
}

class PhaseReader {
 public:
  PhaseReader(const Section& section, const std::string& swept, const std::string& file)
      : section_{section}, swept_{swept}, file_{file} {}

  Phase read() {
    phase_.name = section_.name;
    phase_.line = phase_.goal_line = section_.line;
    with("joints", true, [&](std::string_view text) { readJoints(text); });
    with("duration", true, [&](std::string_view text) { phase_.duration_s = parseNumber(text, kDuration); });
    with("velocity", false, [&](std::string_view text) { phase_.velocity = parseNumber(text, kSpeed); });
    with("acceleration", false, [&](std::string_view text) { phase_.acceleration = parseNumber(text, kAcceleration); });
    with("p_gain", false, [&](std::string_view text) { phase_.p_gain = parseNumber(text, kGain); });
    readTorque();
    readGoal();
    readUntil();
    return phase_;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw std::runtime_error(text::where(file_, line) + ": " + message);
  }

  /// Calls `take` with the value of `key` and adds file and line to its errors. False if the key is absent.
  template <class Take>
  bool with(std::string_view key, bool needed, const Take& take) {
    const Entry* const entry = section_.find(key);
    if (!entry) {
      if (needed) fail(section_.line, "[phase " + section_.name + "] needs '" + std::string{key} + "'");
      return false;
    }
    try {
      if (entry->value == "sweep" && swept_.empty())
        throw std::runtime_error("'" + entry->key + " = sweep' needs a section [sweep] with values");
      take(entry->value == "sweep" ? swept_ : entry->value);
    } catch (const std::runtime_error& wrong) {
      fail(entry->line, wrong.what());
    }
    return true;
  }

  void readJoints(std::string_view text) {
    if (text == kAllJoints) {
      phase_.joints = allMoved();
      return;
    }
    for (std::string_view name : splitList(text)) {
      const bool mirrored = name.starts_with('-');
      const Joint joint = jointNamed(mirrored ? name.substr(1) : name);
      if (std::ranges::find(phase_.joints, joint, &Moved::joint) != phase_.joints.end())
        throw std::runtime_error(std::string{row(joint).name} + " is listed twice");
      phase_.joints.push_back({joint, mirrored ? -1.0 : 1.0});
    }
  }

  void readTorque() {
    with("torque_limit", false, [&](std::string_view text) { phase_.newton_meter = slope(text, kTorqueLimit); });
    with("torque", false, [&](std::string_view text) {
      if (section_.find("torque_limit") != nullptr)
        throw std::runtime_error("a phase has a 'torque' or a 'torque_limit', not both: remove one");
      phase_.torque = text == "off" ? TorqueMode::kOff : TorqueMode::kDirect;
      if (text != "off") phase_.newton_meter = slope(text, kTorque);
    });
  }

  /// "0.5 N m" or "0 N m to 0.5 N m".
  static Slope slope(std::string_view text, const Quantity& quantity) {
    const std::size_t to = text.find(" to ");
    const double begin = parseNumber(text.substr(0, to), quantity);
    return {begin, to == text.npos ? begin : parseNumber(text.substr(to + 4), quantity)};
  }

  void readGoal() {
    Goal& goal = phase_.goal;
    const bool driven = phase_.torque == TorqueMode::kLimit;
    if (!driven && section_.find("goal") != nullptr)
      fail(section_.find("goal")->line, "a phase has a 'torque' or a 'goal', not both: remove one");
    with("goal", driven, [&](std::string_view text) { goal.shape = choice<Shape>(text, kShapeNames); });
    if (driven) checkKeys();
    readNumber("to", [&](std::string_view text) { goal.to = parseNumber(text, kAngle); });
    readNumber("amplitude", [&](std::string_view text) { goal.amplitude = parseNumber(text, kDistance); });
    readNumber("period", [&](std::string_view text) { goal.period_s = parseNumber(text, kDuration); });
    readNumber("goals", [&](std::string_view text) { goal.goals = parseNumbers(text, kAngle); });
    with("frequency", false, [&](std::string_view text) { readFrequencies(text); });
    with("every", false, [&](std::string_view text) { readTimes(text); });
  }

  template <class Take>
  void readNumber(std::string_view key, const Take& take) {
    if (with(key, false, take)) phase_.goal_line = section_.find(key)->line;
  }

  void checkKeys() const {
    const std::string shape{kShapeNames[static_cast<std::size_t>(phase_.goal.shape)]};
    const Words needed = keysOf(phase_.goal.shape);
    for (const std::string_view key : needed)
      if (section_.find(key) == nullptr)
        fail(section_.line, "[phase " + section_.name + "]: goal = " + shape + " needs '" + std::string{key} + "'");
    for (const std::string_view key : {"to", "amplitude", "period", "frequency", "goals", "every"})
      if (const Entry* entry = section_.find(key); entry && std::ranges::find(needed, key) == needed.end())
        fail(entry->line, "'" + std::string{key} + "' has no meaning for goal = " + shape +
                              (needed.empty() ? "" : ", which takes " + text::joined(needed)));
  }

  void readFrequencies(std::string_view text) {
    phase_.goal.hz = parseNumbers(text, kFrequency);
    const std::size_t count = phase_.goal.hz.size();
    if (phase_.goal.shape == Shape::kSine && count != 1) throw std::runtime_error("a sine needs exactly one frequency");
    if (phase_.goal.shape == Shape::kChirp && count != 2)
      throw std::runtime_error("a chirp needs two frequencies, start and end: 0.2 Hz, 3 Hz");
    if (count > 16) throw std::runtime_error("at most 16 frequencies");
  }

  void readTimes(std::string_view text) {
    phase_.goal.every_s = parseNumbers(text, kDuration);
    if (phase_.goal.every_s.size() != 1 && phase_.goal.every_s.size() != phase_.goal.goals.size())
      throw std::runtime_error("'every' needs one time for all goals, or one per goal (" +
                               std::to_string(phase_.goal.goals.size()) + ")");
  }

  void readUntil() {
    with("until", false, [&](std::string_view text) { phase_.until = choice<Until>(text, kUntilNames); });
    with("within", false, [&](std::string_view text) { phase_.within = parseNumber(text, kDistance); });
    const bool arrival = phase_.until == Until::kArrival;
    if (!arrival && section_.find("within") != nullptr)
      fail(section_.find("within")->line, "'within' belongs to until = arrival");
    if (!arrival) return;
    if (section_.find("within") == nullptr || section_.find("to") == nullptr)
      fail(section_.line, "[phase " + section_.name + "]: until = arrival needs 'to' and 'within'");
    phase_.arrive_at = phase_.goal.to;
  }

  const Section& section_;
  const std::string& swept_;
  const std::string& file_;
  Phase phase_;
};

}  // namespace

Phase readPhase(const Section& section, const std::string& swept, const std::string& file) {
  return PhaseReader{section, swept, file}.read();
}

Joint jointNamed(std::string_view name) {
  if (const auto joint = findJoint(name)) return *joint;
  Words names;
  for (const JointRow& joint : kJointTable) names.push_back(joint.name);
  throw std::runtime_error("there is no joint '" + std::string{name} + "'" + didYouMean(name, names) + "; joints are " +
                           text::joined(names));
}

}  // namespace darwinop::experiments
