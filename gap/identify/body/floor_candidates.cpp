#include "gap/identify/body/floor_candidates.hpp"

#include <cmath>

#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

/// Zero errors of the encoders of ankles and feet, of one and of a pair: a foot in the air weighs next to nothing, on
/// the floor they turn the whole robot, as a floor that slopes does.
std::vector<FloorEffect> loadedJointEffects() {
  const twin::EffectInfo& info = *twin::findEffect("encoder_offset");
  const twin::Parameter& offset = info.parameters.front();
  std::vector<FloorEffect> out;
  for (const std::string_view at : {"AnkleR", "AnkleL", "FootR", "FootL", "AnkleR AnkleL", "FootR FootL"})
    out.push_back(
        {.id = info.id,
         .at = at,
         .is_linear = true,
         .is_of_load = true,
         .numbers = {{.key = offset.key,
                      .unit = offset.unit,
                      .low = offset.low,
                      .high = offset.high,
                      .step = offset.typical / 10}},
         .neutral = {offset.neutral},
         .starts = {{offset.typical / 2}},
         .apply = [&info, joints = loadedJointsAt(at)](FloorModel& m, const std::vector<double>& values) {
           for (const std::string_view joint : joints)
             m.robot.robot.servos.with(info, {.kind = Place::Kind::kJoint, .name = std::string{joint}}).values = values;
         }});
  return out;
}

}  // namespace

std::vector<std::string_view> loadedJointsAt(std::string_view at) {
  const std::size_t space = at.find(' ');
  if (space == std::string_view::npos) return {at};
  return {at.substr(0, space), at.substr(space + 1)};
}

std::shared_ptr<const std::vector<FloorEffect>> floorCandidates(const BodyCase& given) {
  auto out = std::make_shared<std::vector<FloorEffect>>(floorEffects(given.joints.model));
  for (FloorEffect& one : loadedJointEffects()) out->push_back(std::move(one));
  for (FloorEffect& one : *out)
    if (one.of_engine == EngineNumber::kContactTime)
      one.engine_sigma = std::hypot(one.engine_sigma, given.sigmaOf("contact_time"));
  return out;
}

}  // namespace darwinop::gap
