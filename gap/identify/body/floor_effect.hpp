// Effects that only recordings on the floor show: contact, trunk, and the inertial sensor in motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

struct FloorEffect {
  struct Number {
    std::string_view key, unit;  // numbers with one key are one vector
    double low, high;
    double step;             // of a derivative
    double prior_sigma = 0;  // about `prior_mean`; 0: flat in the range
    double prior_mean = 0;
    bool is_fixed = false;  // never fitted
    bool is_logarithmic = false;
    double shown_offset = 0;  // of an answer

    /// On the scale on which it is searched; and back, within its range.
    [[nodiscard]] double inSearch(double value) const { return is_logarithmic ? std::log(value) : value; }
    [[nodiscard]] double fromSearch(double x) const { return std::clamp(is_logarithmic ? std::exp(x) : x, low, high); }
    /// In prior standard deviations; 0: none.
    [[nodiscard]] double priorOf(double value) const {
      return prior_sigma > 0 ? (value - prior_mean) / prior_sigma : 0;
    }
  };
  std::string_view id, at;
  bool is_of_sensor = false;                     // needs no simulation
  bool is_linear = false;                        // starts are combined
  EngineNumber of_engine = EngineNumber::kNone;  // its number is also one that engines differ by
  double engine_sigma = 0;                       // by so much, on the scale on which it is searched
  bool is_of_load = false;  // acts by weight or its direction: a mass that moves in a limb looks like it
  std::vector<Number> numbers;
  std::vector<double> neutral;
  std::vector<std::vector<double>> starts;
  std::function<void(FloorModel&, const std::vector<double>& values)> apply;
};

/// For robots near this model. To add one: a row in floor_effect.cpp.
std::vector<FloorEffect> floorEffects(const twin::Model& model);

struct PlacedFloor {
  const FloorEffect* effect = nullptr;
  std::vector<double> values;

  /// Squared standard deviations of what engines differ by in this number; infinite: they do not.
  [[nodiscard]] double costAmongEngines() const;
};
using FloorSet = std::vector<PlacedFloor>;

}  // namespace darwinop::gap
