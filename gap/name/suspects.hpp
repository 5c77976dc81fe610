// Which effects may be missing, and what a fit moves to find out.
#pragma once

#include <cstdint>
#include <vector>

#include "gap/fit/problem.hpp"
#include "gap/fit/solve.hpp"

namespace darwinop::gap {

/// An effect that a fit has, and whether the parameters that only refine it are free, too.
struct Chosen {
  const twin::EffectInfo* info = nullptr;
  bool refined = false;
  bool operator==(const Chosen&) const = default;
};
using Effects = std::vector<Chosen>;

/// Effects of the catalogue that could be missing from this baseline: all but those that its law makes meaningless and
/// those that a position log cannot show.
std::vector<const twin::EffectInfo*> suspectsOf(const Case& given);

bool has(const Effects& effects, const twin::EffectInfo& effect);
Effects without(Effects effects, std::size_t i);

/// A motor that nobody has measured: its numbers are a manual's, or another servo's.
bool isRoughlyKnown(const Case& given);

/// The numbers of the baseline: exactly as given, or moved as far as their priors let them.
enum class Numbers : std::uint8_t { kHeld, kFree };

/// The baseline with `effects`, their parameters free.
Problem problemWith(const Evidence& evidence, const Effects& effects, Numbers numbers);

/// A start for `problem`: each unknown as in `known` where it was known there, else as expected.
Eigen::VectorXd startFrom(const Problem& problem, const Problem& known, const Eigen::VectorXd& x);

/// The same for the effects; the numbers of the baseline as expected.
Eigen::VectorXd startAfresh(const Problem& problem, const Problem& known, const Eigen::VectorXd& x);

}  // namespace darwinop::gap
