// Selection on a roughly known baseline: numbers from a manual, logs of a servo that was not measured before. No model
// fits to the noise, so effects are selected by cross-validation instead. docs/gap/verdicts.md
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/identify/cross_validation.hpp"
#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// `effects` with all numbers free; what `from` leaves counts as noise. The second: on the fit logs of another study.
FittedModel refitWithDiscrepancy(const Effects& effects, const FittedModel& from);
FittedModel refitWithDiscrepancy(const Study& study, const Effects& effects, const FittedModel& from);

/// Every servo has it.
bool isCommon(const twin::EffectInfo& effect);
/// Cost that an effect has to remove to stay.
double leastRoughGain(const twin::EffectInfo& effect);
/// Less is removed by `with`, which has the effect, as against `less`.
bool isNeedless(const twin::EffectInfo& effect, const FittedModel& with, const FittedModel& less);

/// The remaining model discrepancy counts as noise (gap/fit/discrepancy.hpp). The effects that every servo has are
/// fitted together, since each alone stands in for the others; then rarer effects one by one.
class RoughSelection {
 public:
  /// Starts with the effects of `from`. Other starts are compared on the logs of `few`, which may be `study`.
  /// Both and `options` must outlive this. What predicts better is decided by the logs for validation, if they are at
  /// least as many as the fitted ones; else by those and by each fitted log, left out.
  RoughSelection(const Study& study, const Study& few, const IdentifyOptions& options, const FittedModel& from);

  void run();
  [[nodiscard]] Identification result() const;
  /// Replaces the model by `with`, less what is needless there or at the end of its range. False: that took away so
  /// much that nothing is predicted better than before, and the model stays.
  [[nodiscard]] bool accept(FittedModel with);
  [[nodiscard]] const FittedModel& model() const { return model_; }

 private:
  /// A rarer effect that reduces the mean of the prediction errors.
  struct Tested {
    const FittedModel* model = nullptr;
    CrossValidation validation;
    std::vector<double> errors;      // errorsOf(*model)
    std::string_view replaced = {};  // effect of the present model that it replaces; empty: none
    bool refused = false;  // at the end of its range, or nothing is gained once what is needless beside it is gone
  };

  /// Prediction error of each log that decides.
  [[nodiscard]] std::vector<double> errorsOf(const FittedModel& fitted) const;
  /// No fit has to leave any log out.
  [[nodiscard]] bool validationSuffices() const;
  void addCommonEffects();
  /// The model with a richer law in place of one of its effects, for each that explains more.
  [[nodiscard]] std::vector<FittedModel> richerForms() const;
  [[nodiscard]] bool addRareEffect();
  /// Those of `candidates` that are tested are fitted more finely.
  [[nodiscard]] std::vector<Tested> testRareEffects(std::vector<FittedModel>& candidates);
  /// Those of `tested` that predict the logs neither better nor worse than `best`, null: than the present model.
  void noteRivals(const std::vector<Tested>& tested, const Tested* best);
  /// Effects of a rival, less those that are as needless there as beside the effect that was accepted. `offered`: the
  /// effects of the accepted model, before.
  [[nodiscard]] Effects neededOf(const FittedModel& rival, const Effects& offered) const;
  /// Of the effects that these logs cannot show: the doubles that predict the logs as well in their place.
  void noteDoubles();
  [[nodiscard]] std::string_view replacedBy(const FittedModel& candidate) const;
  void reportPrediction(const twin::EffectInfo& effect, const CrossValidation& validation) const;
  [[nodiscard]] bool predictsAsWell(const FittedModel& other) const;
  [[nodiscard]] bool worsensHeldOut(const FittedModel& with) const;
  void dropNeedless();
  void dropAtBounds();
  /// Drops effects whose intervals contain "no effect" and that do not help to predict either.
  void dropUncertain();
  [[nodiscard]] std::optional<std::size_t> leastAtBound() const;
  [[nodiscard]] FittedModel fitFromStarts(const Effects& effects, const FittedModel& bare) const;
  [[nodiscard]] Verdict verdictWithRemainder(const Identification& found) const;
  [[nodiscard]] bool hasAll(const std::vector<std::string>& effects) const;

  const Study &study_, &few_;
  const IdentifyOptions& options_;
  const Case validation_;  // no fit uses its logs
  double floor_rad_;       // of the encoder
  std::vector<const twin::EffectInfo*> candidates_;
  FittedModel model_;
  std::vector<double> errors_;  // errorsOf(model_)
  std::vector<Rival> rivals_;
  std::vector<RejectedEffect> rejected_;
};

}  // namespace darwinop::gap
