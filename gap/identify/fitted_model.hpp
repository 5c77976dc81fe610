// A set of effects, fitted, with the noise model that belongs to the fit.
#pragma once

#include <memory>

#include "gap/identify/effect_set.hpp"

namespace darwinop::gap {

struct FittedModel {
  const Study* study;
  Effects effects;
  Nuisance nuisance = Nuisance::kFree;
  std::shared_ptr<const Evidence> evidence;
  Problem problem;
  Fit fit;
  double total = 0;  // cost plus the log determinant of the noise: comparable between fits with different noise

  [[nodiscard]] Hypothesis hypothesis() const { return problem.at(fit.x); }
};

/// Twice the log evidence (marginal likelihood) in Laplace's approximation: each free parameter is paid for.
double modelEvidence(const FittedModel& fitted);

/// Fits `effects`, recomputes the noise at the result, and repeats until the noise no longer changes; at most `rounds`
/// times. Starts at `known`, a fit of `from`.
FittedModel refit(const Study& study, const Effects& effects, Nuisance nuisance, const Problem& from, const Fit& known,
                  int rounds = 3);
/// The same, starting at `from`.
FittedModel refit(const FittedModel& from, const Effects& effects, int rounds);

/// The baseline without additions.
FittedModel baselineAlone(const Study& study, Nuisance nuisance);

/// The same values with all baseline numbers free: their Jacobian and covariance.
FittedModel withFreeNuisance(const FittedModel& fitted);

/// The same values under the noise that this model predicts, without a discrepancy term.
FittedModel evaluateUnderOwnNoise(const FittedModel& fitted);

/// The same effects, refitted under the noise of `reference`: costs of both are then comparable sample by sample.
/// Without a Jacobian unless requested.
FittedModel refitUnderNoiseOf(const FittedModel& other, const FittedModel& reference, bool jacobian = false);
FittedModel refitUnderNoiseOf(const Effects& effects, Nuisance nuisance, const Problem& from, const Fit& known,
                              const FittedModel& reference, bool jacobian = false);
/// `fitted` without its effect `i`, under the same noise.
FittedModel refitWithout(const FittedModel& fitted, std::size_t i, bool jacobian = false);
/// The model without its effect `i`: every number that is free is fitted again to make up for it. A number that the
/// effect stands for is as the baseline has it, if the effect moves it beyond what its prior explains.
Hypothesis modelWithout(const FittedModel& fitted, std::size_t i);
/// `x` with the effect as the baseline has it, or not at all.
Eigen::VectorXd takenOut(const FittedModel& fitted, const ChosenEffect& effect, Eigen::VectorXd x);
/// Takes the effect out of the model: as the baseline has it, or not at all.
void takeOut(const twin::EffectInfo& effect, const Hypothesis& baseline, Hypothesis& model);

}  // namespace darwinop::gap
