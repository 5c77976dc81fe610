// Which effects are missing from a model: verdict, effects with intervals, rivals, rejected effects.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/study.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

enum class Verdict : std::uint8_t { kNone, kNamed, kAmbiguous, kUnknown, kCannotTell, kBadInput };
std::string_view nameOf(Verdict verdict);
/// Of the command: 0 none, 10 named, 11 ambiguous, 12 unknown, 13 cannot_tell, 2 bad_input.
int exitCodeOf(Verdict verdict);

struct Estimate {
  std::string name;  // "coulomb.friction"
  std::string unit;
  double value = 0, low = 0, high = 0;  // 90 % interval
  bool seen = true;                     // false: not identifiable from these data; any value of the range will do
};

struct IdentifiedEffect {
  const twin::EffectInfo* effect = nullptr;
  std::vector<Estimate> estimates;
  double gain = 0;         // cost that it removes, the other effects being there
  bool corrected = false;  // the baseline had it, with other values
};

/// A number of the baseline that the data pull out of its prior.
struct PriorConflict {
  std::string number;
  double sigmas = 0, factor = 1;
};

struct Rival {
  std::vector<std::string> effects;  // ids, in place of the identified ones
  double behind = 0;                 // twice the log evidence
  bool larger = false;               // has more free parameters

  /// The data do not exclude it.
  [[nodiscard]] bool isClose() const {
    return behind < (larger ? thresholds::kLargerRivalEvidence : thresholds::kRivalEvidence);
  }
};

/// Why an effect that improves the fit is not named: the measured voltage contradicts it; it improves the prediction
/// of some logs and not of others; of none; it worsens the held-out logs; it removes more than chance would and hardly
/// anything of the gap.
enum class RejectionReason : std::uint8_t { kVoltage, kUndecided, kNoPredictiveGain, kWorsensHeldOut, kSmallShare };
/// As results.json has it: "voltage", "undecided", "no_predictive_gain", "worsens_held_out", "small_share".
std::string_view nameOf(RejectionReason reason);
struct RejectedEffect {
  const twin::EffectInfo* effect = nullptr;
  RejectionReason why = RejectionReason::kNoPredictiveGain;
};

struct Identification {
  Verdict verdict = Verdict::kNone;
  std::vector<IdentifiedEffect>
      effects;                // strongest first; for `ambiguous` in the order found, the one with rivals last
  std::vector<Rival> rivals;  // nearest first
  std::vector<PriorConflict> prior_conflicts;
  std::vector<RejectedEffect> rejected;
  std::vector<IdentifiedEffect> withdrawn;  // of `unknown`: the best set that was tried; not in `model`
  // Gain that chance exceeds in 1 % of cases; in 2.5 % where the model is plainly wrong. NaN: isSelectedByPrediction().
  double threshold = 0;
  double misfit = 0;                             // of the final model, bootstrap standard deviations
  double gap_before_rad = 0, gap_after_rad = 0;  // rms position error over the fit logs, closed loop
  double floor_rad = 0;                          // the same of a right model: noise alone
  Hypothesis model;                              // the baseline with the effects
  std::vector<std::string> explained;            // files of the logs that alone were fitted; empty: all were
  bool too_few_logs = false;  // `cannot_tell`: a roughly known motor, and fewer than three logs that decide
  bool remains = false;       // named or ambiguous, with a remainder that no further effect was found to explain

  /// Chance and evidence say nothing of a model that is wrong: effects and rivals are those that predict.
  [[nodiscard]] bool isSelectedByPrediction() const { return std::isnan(threshold); }
};

struct IdentifyOptions {
  int most_effects = 4;
  double alpha = 0.01;                                                           // false alarms by chance
  std::function<void(const std::string&)> progress = [](const std::string&) {};  // the current step, in a few words
};

Identification identify(const Study& study, const IdentifyOptions& options = {});

}  // namespace darwinop::gap
