// Numbers of a limb that the case declares uncertain.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/plant/body/limb_roll_out.hpp"

namespace darwinop::gap {

struct BodyNuisance {
  std::string name;
  std::function<void(BodyHypothesis&, double sigmas)> move;  // from where the hypothesis has it
  /// An effect of the hypothesis has a number of its own in its place. Empty: never.
  std::function<bool(const BodyHypothesis&)> is_replaced = {};
  /// The effect of one joint or link that adds to the same number, and how far its values move that, in prior standard
  /// deviations.
  std::string_view effect = {};
  Joint at{};
  std::function<double(const std::vector<double>& values)> sigmas_of = {};
};

/// By BodyCase::trust; none where the model is exact.
std::vector<BodyNuisance> nuisancesOf(const BodyCase& given, const Limb& limb);

}  // namespace darwinop::gap
