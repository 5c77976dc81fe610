// One case of the whole robot: what is asked for, and the case with its key.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gap/benchmark/body/body_effects.hpp"
#include "gap/benchmark/body/body_motions.hpp"

namespace darwinop::gap {

struct BodyRequest {
  std::string name = {};  // of the case; must not reveal the effect
  std::uint64_t seed = 1;
  std::vector<BodyEffect> effects = {};
  bool wrong_numbers = false;             // of the model, within their priors
  std::vector<BodyKeyEffect> given = {};  // hidden as well, with these places and sizes
  FloorMotions on_floor = FloorMotions::kWalks;
  int tries = 12;  // until the robot does not fall and its recordings show each effect; the last one is kept as it is
};

struct HiddenBody {
  BodyCase given;
  BodyKey key;
};
/// The case in memory. The same for the same request.
HiddenBody hiddenBody(const BodyRequest& request);

}  // namespace darwinop::gap
