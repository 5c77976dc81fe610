// A set of effects, fitted, with the noise that belongs to the fit.
#pragma once

#include <memory>

#include "gap/name/suspects.hpp"

namespace darwinop::gap {

struct Settled {
  Effects effects;
  Numbers numbers = Numbers::kFree;
  std::shared_ptr<const Evidence> evidence;
  Problem problem;
  Fit fit;
  double total = 0;  // cost, and what the noise costs: comparable between fits with different noise

  [[nodiscard]] Hypothesis hypothesis() const { return problem.at(fit.x); }
};

/// Twice the logarithm of the evidence, as Laplace approximates it: a set of effects pays for each number it may
/// choose.
double evidenceFor(const Settled& fitted);

/// Finds the noise at what was fitted, fits `effects`, and again, until it stays where it is. `from` and `known`: where
/// to begin.
Settled settle(const Effects& effects, Numbers numbers, const Problem& from, const Fit& known, int rounds = 3);

/// The same values, with the slopes and the covariance that the freedom of all numbers gives them.
Settled withFreeNumbers(const Settled& fitted);

/// The same values on the noise that they themselves make, whatever they leave unexplained.
Settled onNoiseOfItsOwn(const Settled& fitted);

/// The same effects on the noise of another fit, for a comparison sample by sample; without slopes, but for `slopes`.
Settled onNoiseOf(const Settled& other, const Settled& judge, bool slopes = false);
Settled onNoiseOf(const Effects& effects, Numbers numbers, const Problem& from, const Fit& known, const Settled& judge,
                  bool slopes = false);

}  // namespace darwinop::gap
