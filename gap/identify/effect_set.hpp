// A set of effects as a fit problem: which effects may be missing, and which numbers a fit moves.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gap/fit/problem.hpp"
#include "gap/fit/solve.hpp"
#include "gap/study.hpp"

namespace darwinop::gap {

/// An effect of a fit; `refined`: its secondary parameters are free as well.
struct ChosenEffect {
  const twin::EffectInfo* info = nullptr;
  bool refined = false;
  Place place = {};
  bool operator==(const ChosenEffect&) const = default;
};
using Effects = std::vector<ChosenEffect>;

/// Effects of the catalogue that may be missing from this baseline: without those that its control law has no place
/// for and those that a position log cannot show.
std::vector<const twin::EffectInfo*> candidateEffectsOf(const Case& data);

bool has(const Effects& effects, const twin::EffectInfo& effect);
Effects without(Effects effects, std::size_t i);
std::vector<std::string> idsOf(const Effects& effects);

/// True for a motor that was not measured: its numbers are a manual's, or another servo's.
bool isRoughlyKnown(const Case& data);

/// Numbers of the baseline in a fit: fixed at their given values, or free under their priors.
enum class Nuisance : std::uint8_t { kFixed, kFree };

/// The study's baseline with `effects`, their parameters free.
Problem problemWith(const Study& study, const Evidence& evidence, const Effects& effects, Nuisance nuisance);

/// A start for `problem`: each unknown as in `known` if it is there, else its expected value.
Eigen::VectorXd startFrom(const Problem& problem, const Problem& known, const Eigen::VectorXd& x);

/// The same for the effects; the numbers of the baseline start at their expected values.
Eigen::VectorXd startAfresh(const Problem& problem, const Problem& known, const Eigen::VectorXd& x);

}  // namespace darwinop::gap
