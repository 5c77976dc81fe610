#include "gap/identify/body/floor_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "gap/plant/body/joint_alone.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

double valueAt(const Hypothesis& robot, const twin::EffectInfo& info, std::string_view joint) {
  const Hypothesis alone = atJoint(robot, findJoint(std::string{joint}).value());
  const twin::EffectSetting* const there = alone.find(info.id);
  return there != nullptr ? there->values.front() : info.parameters.front().neutral;
}

/// Zero errors of the encoders of ankles and feet, of one and of a pair: a foot in the air weighs next to nothing, on
/// the floor they turn the whole robot, as a floor that slopes does.
std::vector<FloorEffect> loadedJointEffects(const Hypothesis& declared, const Hypothesis& about) {
  const twin::EffectInfo& info = *twin::findEffect("encoder_offset");
  const twin::Parameter& offset = info.parameters.front();
  std::vector<FloorEffect> out;
  for (const std::string_view at : {"AnkleR", "AnkleL", "FootR", "FootL", "AnkleR AnkleL", "FootR FootL"}) {
    const std::vector<std::string_view> joints = loadedJointsAt(at);
    const double own = valueAt(declared, info, joints.front());
    const auto has_it = [&](std::string_view joint) {
      return valueAt(declared, info, joint) == own && valueAt(about, info, joint) == own;
    };
    if (!std::ranges::all_of(joints, has_it)) continue;
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
         .neutral = {own},
         .starts = {{own + offset.typical / 2}},
         .apply = [&info, joints](FloorModel& m, const std::vector<double>& values) {
           for (const std::string_view joint : joints)
             m.robot.robot.servos.with(info, {.kind = Place::Kind::kJoint, .name = std::string{joint}}).values = values;
         }});
  }
  return out;
}

}  // namespace

std::vector<std::string_view> loadedJointsAt(std::string_view at) {
  const std::size_t space = at.find(' ');
  if (space == std::string_view::npos) return {at};
  return {at.substr(0, space), at.substr(space + 1)};
}

std::shared_ptr<const std::vector<FloorEffect>> floorCandidates(const BodyCase& given, const FloorModel& about) {
  auto out = std::make_shared<std::vector<FloorEffect>>(floorEffects(given.joints.model));
  for (FloorEffect& one : loadedJointEffects(bodyBaselineOf(given), about.robot.robot.servos))
    out->push_back(std::move(one));
  for (FloorEffect& one : *out)
    if (one.of_engine == EngineNumber::kContactTime)
      one.engine_sigma = std::hypot(one.engine_sigma, given.sigmaOf("contact_time"));
  return out;
}

}  // namespace darwinop::gap
