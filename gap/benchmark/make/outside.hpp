// Effects outside the catalogue, for which `unknown` is the right verdict. No other folder uses them.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "twin/bench/bench.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::gap {

struct OutsideParameter {
  std::string_view key, unit;
  double low, high;  // drawn from here; the result shows plainly
};

struct OutsideInfo {
  std::string_view id, title;
  std::span<const OutsideParameter> parameters;
  /// Acts on the arm of one log.
  std::unique_ptr<twin::Effect> (*make)(std::span<const double> values, const twin::Pendulum& arm);
};

struct OutsideSetting {
  const OutsideInfo* info = nullptr;
  std::vector<double> values;
};

std::span<const OutsideInfo> outsideCatalogue();
/// Null: there is none of this name.
const OutsideInfo* findOutside(std::string_view id);
OutsideSetting drawnOutside(const OutsideInfo& info, Rng& rng);

}  // namespace darwinop::gap
