#include "gap/localize/body/drawn_robot.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "core/random.hpp"
#include "gap/localize/body/body_nuisances.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

FloorHypothesis drawn(const BodyCase& given, const FloorHypothesis& about, const std::vector<Limb>& limbs,
                      double trunk_kg, std::uint64_t seed) {
  Rng rng{splitMix(seed)};
  FloorHypothesis out = about;
  std::set<std::string> of_all_servos;
  for (const Limb& limb : limbs)
    for (const BodyNuisance& number : nuisancesOf(given, limb)) {
      // Numbers of all servos come with each limb.
      const bool is_common = number.name.find(' ') == std::string::npos;
      if (is_common && !of_all_servos.insert(number.name).second) continue;
      number.move(out.robot, rng.normal());
    }
  FloorChange& floor = out.floor;
  floor.friction_factor *= std::max(thresholds::kLeastPriorShare, 1 + given.sigmaOf("floor_friction") * rng.normal());
  floor.contact_time_factor *= std::max(thresholds::kLeastPriorShare, 1 + given.sigmaOf("contact_time") * rng.normal());
  floor.trunk_mass_kg += given.sigmaOf("body.mass") * trunk_kg * rng.normal();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    floor.trunk_com_shift_m[axis] += given.sigmaOf("body.com_m") * rng.normal();
  return out;
}

}  // namespace

std::vector<FloorHypothesis> drawnRobots(const BodyCase& given, const FloorHypothesis& about, std::uint64_t first,
                                         std::size_t count) {
  std::vector<FloorHypothesis> out;
  if (count == 0) return out;
  const std::vector<Limb> limbs = limbsOf(given.joints.model);
  const double trunk_kg = trunkMass(given.joints.model);
  for (std::size_t i = 0; i < count; ++i) out.push_back(drawn(given, about, limbs, trunk_kg, first + i));
  return out;
}

}  // namespace darwinop::gap
