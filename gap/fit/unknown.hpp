// An unknown of a fit: a number of the servo, of the load, of the host, or of an effect, with its prior.
#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "gap/plant/baseline_number.hpp"
#include "gap/plant/write_instant.hpp"

namespace darwinop::gap {

/// A parameter of an effect, in its own unit.
struct EffectParameter {
  const twin::EffectInfo* info = nullptr;
  std::size_t index = 0;
  Place place = {};

  [[nodiscard]] const twin::Parameter& row() const { return info->parameters[index]; }
};

struct Unknown {
  std::string name;  // "kt", "coulomb.friction", of a place with a name "AnkleR.coulomb.friction"
  std::variant<LoadFactor, ServoFactor, EffectParameter, WriteTime> what;
  double expected = 1;                                     // mean of the prior; where a search begins
  double sigma = std::numeric_limits<double>::infinity();  // of the prior; infinity: nothing is known
  double low = 0, high = 0;                                // bounds of the search
  bool logarithmic = false;                                // searched in its logarithm

  /// Between value and search variable.
  [[nodiscard]] double toSearch(double value) const;
  [[nodiscard]] double fromSearch(double x) const;
  /// Null: not a parameter of this effect.
  [[nodiscard]] const EffectParameter* parameterOf(const twin::EffectInfo& effect) const;
  /// First step of a finite difference, in the search variable.
  [[nodiscard]] double firstStep() const;
};

/// Numbers of the baseline that have a prior. Those of an effect count only if the hypothesis has the effect.
std::vector<Unknown> nuisancesOf(const Case& given, const Hypothesis& hypothesis);
/// Parameters of an effect, without prior. `refined`: the secondary ones as well.
std::vector<Unknown> unknownsOf(const twin::EffectInfo& info, bool refined = false, const Place& place = {});

/// `hypothesis` with the unknowns at these values of the search variables.
Hypothesis applied(Hypothesis hypothesis, const std::vector<Unknown>& unknowns, const double* x);

}  // namespace darwinop::gap
