#include "gap/plant/body/joint_alone.hpp"

#include <string>

#include "gap/plant/bench/bench_plant.hpp"

namespace darwinop::gap {
namespace {

Place placeOf(Joint joint) {
  return {.kind = Place::Kind::kJoint, .name = std::string{row(joint).name}};
}

}  // namespace

Hypothesis bodyBaselineOf(const BodyCase& given) {
  Hypothesis robot{.servo = given.joints.model.servo, .effects = {}, .pendulum = {}, .payload_scale = 1};
  for (const twin::EffectSetting& effect : given.joints.model.effects)
    robot.with(*effect.info, effect.joint ? placeOf(*effect.joint) : Place{}).values = effect.values;
  return robot;
}

Hypothesis atJoint(const Hypothesis& robot, Joint joint) {
  const Place own = placeOf(joint);
  Hypothesis alone{.servo = robot.servo, .effects = {}, .pendulum = robot.pendulum, .payload_scale = 1};
  for (const PlacedEffect& effect : robot.effects) {
    const bool is_overridden = effect.place == Place{} && robot.find(effect.info->id, own) != nullptr;
    if (effect.place == own || (effect.place == Place{} && !is_overridden))
      alone.with(*effect.info).values = effect.values;
  }
  return alone;
}

BlockResiduals jointResiduals(Block block, const BodyCase& given, const Trajectory& log, const Hypothesis& robot) {
  static const BenchPlant kAlone;
  return kAlone.blockResiduals(block, Place{}, given.joints, log, atJoint(robot, log.joint.value()), {});
}

}  // namespace darwinop::gap
