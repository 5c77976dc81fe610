#include "gap/benchmark/body/given_effects.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "gap/identify/body/floor_effect.hpp"
#include "gap/identify/body/mechanical_effect.hpp"
#include "gap/identify/body/sensor_effect.hpp"

namespace darwinop::gap {
namespace {

/// In the order of an effect's numbers; those with one key are one vector.
template <class Numbers>
std::vector<double> inOrder(const Numbers& numbers, std::vector<double> values, const BodyKeyEffect& effect) {
  std::map<std::string, std::size_t> taken;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string key{numbers[i].key};
    const auto of = effect.values.find(key);
    if (of != effect.values.end()) values[i] = of->second.at(taken[key]++);
  }
  return values;
}

/// False: it has no such effect at this place.
bool hideOnFloor(const BodyKeyEffect& effect, const BodyCase& plan, BodyTruth& truth) {
  for (const FloorEffect& one : floorEffects(plan.joints.model)) {
    if (one.id != effect.id || effect.at != std::vector<std::string>{std::string{one.at}}) continue;
    one.apply(truth.model, inOrder(one.numbers, one.neutral, effect));
    return true;
  }
  return false;
}

bool hideInSensor(const BodyKeyEffect& effect, BodyTruth& truth) {
  for (const SensorEffect& one : sensorEffects()) {
    if (one.id != effect.id) continue;
    applyTo(truth.model.imu, one, effect.values.at(std::string{one.parameter}));
    return true;
  }
  return false;
}

bool hideInJoints(const BodyKeyEffect& effect, BodyTruth& truth) {
  const auto& all = mechanicalEffects();
  const auto found = std::ranges::find(all, effect.id, &MechanicalEffect::id);
  if (found == all.end()) return false;
  BodyHypothesis& robot = truth.model.robot.robot;
  for (const JointRow& row : kJointTable) {
    const bool is_meant = effect.at == std::vector<std::string>{"all"} || std::ranges::count(effect.at, row.name) > 0;
    const auto joint = static_cast<Joint>(&row - std::begin(kJointTable));
    if (is_meant) found->apply(robot, joint, inOrder(found->numbers, found->values_in(robot, joint), effect));
  }
  return true;
}

}  // namespace

void hide(const BodyKeyEffect& effect, const BodyCase& plan, BodyTruth& truth, BodyKey& key) {
  if (!hideOnFloor(effect, plan, truth) && !hideInSensor(effect, truth) && !hideInJoints(effect, truth))
    throw std::logic_error("no catalogue has " + effect.id);
  key.effects.push_back(effect);
}

}  // namespace darwinop::gap
