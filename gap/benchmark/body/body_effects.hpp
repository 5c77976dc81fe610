// Effects that can be hidden in a robot: drawn place and size, so strong that they show.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "gap/benchmark/body/body_key.hpp"
#include "gap/benchmark/body/body_physics.hpp"

namespace darwinop::gap {

enum class BodyClass : std::uint8_t { kSensor, kMass, kContact, kOneJoint, kPair, kAll, kBus, kOutside };

struct BodyEffect {
  std::string id;
  BodyClass kind = BodyClass::kSensor;
};

/// Every effect of the catalogue, and some that no catalogue has.
const std::vector<BodyEffect>& bodyEffects();
/// "gyro_bias", "coulomb" (one joint), "coulomb@pair", "coulomb@all". Throws std::runtime_error, a sentence.
BodyEffect bodyEffectCalled(const std::string& text);

/// Hides it and adds it to the key.
void hide(const BodyEffect& effect, const BodyCase& plan, Rng& rng, BodyTruth& truth, BodyKey& key);

}  // namespace darwinop::gap
