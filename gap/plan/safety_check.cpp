#include "gap/plan/safety_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/servo_limits.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/quantity.hpp"
#include "gap/plan/commands.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plan/thresholds.hpp"
#include "gap/plants.hpp"

namespace darwinop::gap {
namespace {

using experiments::Phase;
using experiments::Round;
using experiments::shortText;

struct Danger {
  std::string sentence;
  double at_s = 0;         // of the round
  bool by_effort = false;  // less of it would do
};

class Watch {
 public:
  Watch(const ArmSetup& stand, const Hypothesis& hypothesis)
      : range_{safety::hardRange(stand.joint)},
        name_{row(stand.joint).name},
        hangs_at_{stand.hangs_at_rad},
        full_{hypothesis.servo.overload_share * hypothesis.servo.duty_max},
        longest_{thresholds::kAllowedOverloadShare * hypothesis.servo.overload_time_s} {}

  std::optional<Danger> look(const Stretch& stretch, const Trace& trace) {
    for (std::size_t i = 0; i < trace[kPositionSignal].size(); ++i) {
      const double t = stretch.begins_s + stretch.log.time_s[i];
      const double angle = trace[kPositionSignal][i] + hangs_at_, speed = std::abs(trace[kSpeedSignal][i]);
      if (!std::isfinite(angle)) return Danger{"the simulation breaks down", t};
      if (angle < range_.low.value - thresholds::kAllowedOvershoot ||
          angle > range_.high.value + thresholds::kAllowedOvershoot)
        return Danger{name_ + " would get to " + shortText(angle) + " rad; its limits are " +
                          shortText(range_.low.value) + " to " + shortText(range_.high.value) + " rad",
                      t};
      if (speed > kFullSpeed)
        return Danger{name_ + " would turn at " + shortText(speed) + " rad/s; at most " + shortText(kFullSpeed) +
                          " rad/s are allowed",
                      t};
      full_s_ = std::abs(trace[kLoadSignal][i]) >= full_ ? full_s_ + kPlannedRow : 0;
      if (full_s_ > longest_)
        return Danger{"the servo would run at full duty for more than " + shortText(longest_) +
                          " s; it shuts itself off after " + shortText(longest_ / thresholds::kAllowedOverloadShare) +
                          " s",
                      t, true};
    }
    return std::nullopt;
  }

 private:
  safety::JointRange range_;
  std::string name_;
  double hangs_at_, full_, longest_;
  double full_s_ = 0;  // at full duty without a pause, until now
};

std::optional<Danger> dangerOf(const ExperimentCandidate& candidate, const Round& round, const ArmSetup& stand,
                               const Case& given, const std::vector<Hypothesis>& hypotheses) {
  const std::vector<Stretch> stretches = commandsOf(candidate, round, stand);
  const Case coming = planned(given, stretches);
  Trace trace;
  for (const Hypothesis& hypothesis : hypotheses) {
    Watch watch{stand, hypothesis};
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      plantOf(coming).rollOut(coming, i, hypothesis, {}, trace);
      if (auto danger = watch.look(stretches[i], trace)) return danger;
    }
  }
  return std::nullopt;
}

/// Ends the round at `at_s`. False: the phase there cannot be ended early without becoming another motion.
bool endAt(Round& round, double at_s) {
  double begins = 0;
  for (std::size_t i = 0; i < round.phases.size(); ++i) {
    Phase& phase = round.phases[i];
    if (begins + phase.duration_s <= at_s) {
      begins += phase.duration_s;
      continue;
    }
    using experiments::Shape;
    const bool other =
        phase.goal.shape == Shape::kMove || phase.goal.shape == Shape::kRamp || phase.goal.shape == Shape::kChirp;
    if (other || at_s < thresholds::kShortestRound) return false;
    phase.duration_s = std::floor((at_s - begins) * 10) / 10;
    round.phases.resize(phase.duration_s > 0 ? i + 1 : i);
    return !round.phases.empty();
  }
  return false;
}

std::string called(const Round& round) {
  return round.label.empty() ? "a round" : "the round with " + round.label;
}

/// Changes the round until nothing is wrong with it. Empty: it may stay.
std::string tame(const ExperimentCandidate& candidate, Round& round, const ArmSetup& stand, const Case& given,
                 const std::vector<Hypothesis>& hypotheses, std::vector<std::string>& cuts) {
  std::string why;
  for (int i = 0; i < thresholds::kSafetyAttempts; ++i) {
    const std::optional<Danger> danger = dangerOf(candidate, round, stand, given, hypotheses);
    if (!danger) return {};
    why = danger->sentence;
    if (!danger->by_effort || !endAt(round, danger->at_s - 0.1)) break;
    cuts.push_back(called(round) + " ends after " + shortText(std::floor(danger->at_s * 10 - 1) / 10) + " s: " + why);
  }
  return why;
}

}  // namespace

Vetted vetted(ExperimentCandidate candidate, const ArmSetup& stand, const Case& given,
              const std::vector<Hypothesis>& hypotheses) {
  Vetted out{std::move(candidate), {}, {}, 0};
  experiments::Experiment& experiment = out.candidate.experiment;
  const auto refuse = [&](const std::string& why) {
    out.refused = why;
    return out;
  };
  for (const Round& round : experiment.rounds)
    for (const experiments::Phase& phase : round.phases)
      if (phase.p_gain > kMaxPGain)
        return refuse(shortText(phase.p_gain) + messages::kGainBeyondFormat + shortText(kMaxPGain));
  try {
    (void)experiments::makePlan(experiment, safety::hardRanges());
    std::vector<Round> kept;
    std::string why;
    for (Round& round : experiment.rounds) {
      std::vector<std::string> cuts;
      const std::string wrong = tame(out.candidate, round, stand, given, hypotheses, cuts);
      if (!wrong.empty()) {
        why = wrong;
        out.cuts.push_back("without " + called(round) + ": " + wrong);
        continue;
      }
      out.cuts.insert(out.cuts.end(), cuts.begin(), cuts.end());
      kept.push_back(round);
    }
    if (kept.empty()) return refuse(why);
    experiment.rounds = std::move(kept);
    out.seconds = experiments::makePlan(experiment, safety::hardRanges()).seconds() + out.candidate.prepare_s;
  } catch (const std::runtime_error& error) {
    return refuse(error.what());
  }
  return out;
}

}  // namespace darwinop::gap
