// Numbers of a limb that the case declares uncertain.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gap/plant/body/limb_roll_out.hpp"

namespace darwinop::gap {

struct BodyNuisance {
  std::string name;
  std::function<void(BodyHypothesis&, double sigmas)> move;  // from where the hypothesis has it
  /// An effect of the hypothesis has a number of its own in its place. Empty: never.
  std::function<bool(const BodyHypothesis&)> is_replaced = {};
};

/// By BodyCase::trust; none where the model is exact.
std::vector<BodyNuisance> nuisancesOf(const BodyCase& given, const Limb& limb);

}  // namespace darwinop::gap
