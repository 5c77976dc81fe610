// Own suite of the whole robot: cases by seed, over all effects and places.
#pragma once

#include <cstdint>
#include <functional>
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
  int tries = 6;  // until a robot does not fall; the last one is kept, even if it does
};

enum class BodyPart : std::uint8_t { kQuick, kSingles, kEffectFree, kPairs, kOutside, kAll };

/// Requests in random order, under neutral names.
std::vector<BodyRequest> bodyRequests(std::uint64_t seed, BodyPart part);
/// One case for each of them.
std::vector<BodyRequest> bodyRequestsFor(std::uint64_t seed, const std::vector<std::string>& effects);

struct HiddenBody {
  BodyCase given;
  BodyKey key;
};
/// The case in memory. The same for the same request.
HiddenBody hiddenBody(const BodyRequest& request);

/// Writes FOLDER/cases/* and FOLDER/key.json, which must not be there yet.
void makeBodyCases(const std::string& folder, const std::vector<BodyRequest>& requests,
                   const std::function<void(std::size_t done, std::size_t of)>& progress = {});

}  // namespace darwinop::gap
