// Selection on a roughly known baseline: numbers from a manual, logs of a servo that was not measured before. No model
// fits to the noise, so effects are selected by cross-validation instead. docs/gap/verdicts.md
#pragma once

#include <string>
#include <vector>

#include "gap/identify/cross_validation.hpp"
#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// The remaining model discrepancy counts as noise (gap/fit/discrepancy.hpp). The effects that every servo has are
/// fitted together, since each alone stands in for the others; then rarer effects one by one.
class RoughSelection {
 public:
  /// Starts with `effects`, fitted by `from`. `study` and `options` must outlive this.
  RoughSelection(const Study& study, const IdentifyOptions& options, const Effects& effects, const FittedModel& from);

  void run();
  [[nodiscard]] Identification result() const;

 private:
  /// A rarer effect with the errors that it predicts.
  struct Tested {
    const FittedModel* model = nullptr;
    CrossValidation validation;
  };

  void addCommonEffects();
  [[nodiscard]] bool addRareEffect();
  [[nodiscard]] std::vector<Tested> testRareEffects(const std::vector<FittedModel>& candidates);
  void dropNeedless();
  [[nodiscard]] Verdict verdictWithRemainder(const Identification& found) const;
  [[nodiscard]] bool hasAll(const std::vector<std::string>& effects) const;

  const Study& study_;
  const IdentifyOptions& options_;
  std::vector<const twin::EffectInfo*> candidates_;
  FittedModel model_;
  std::vector<Rival> rivals_;
  std::vector<RejectedEffect> rejected_;
};

}  // namespace darwinop::gap
