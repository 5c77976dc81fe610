// Maps the parameter names of other suites to those of the catalogue.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "twin/servo/facets.hpp"

namespace darwinop::gap {

/// A parameter by the catalogue's name.
struct NamedParameter {
  std::string_view key;
  double zero = 0;  // of the other scale: 1 where it is a factor and ours is a change
};
/// "Fc" of coulomb is "friction". Nothing: a number that is no parameter of the effect.
std::optional<NamedParameter> parameterOf(std::string_view effect, std::string_view name);

/// With the catalogue's names, unknown ones left out.
std::map<std::string, double> inCatalogueNames(std::string_view effect, const std::map<std::string, double>& values);

/// How an estimate of this parameter is compared with the truth.
twin::ErrorScale errorScaleOf(std::string_view effect, std::string_view key);

/// Relative error of `estimate`. A factor counts from 1: 0.96 instead of a scale of 0.95 is an error of a fifth.
/// Nothing where no relative error is defined: a phase, a truth of 0.
std::optional<double> relativeError(std::string_view effect, std::string_view key, double estimate, double truth);

}  // namespace darwinop::gap
