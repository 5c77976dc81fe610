#include "gap/identify/body/answer_model.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/text/nearest.hpp"
#include "gap/identify/body/battery.hpp"
#include "gap/identify/body/floor_effect.hpp"
#include "gap/identify/body/mechanical_effect.hpp"
#include "gap/identify/body/sensor_effect.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

/// Number `index` of a parameter, which is a number or a list; `otherwise`: it is not there.
double numberOf(const json& params, std::string_view key, std::size_t index, double otherwise) {
  const auto found = params.find(std::string{key});
  if (found == params.end()) return otherwise;
  return found->is_array() ? found->at(index).get<double>() : found->get<double>();
}

void addFloor(AnsweredRobot& robot, const FloorEffect& effect, const json& params) {
  std::vector<double> values;
  std::size_t index = 0;
  for (std::size_t i = 0; i < effect.numbers.size(); ++i) {
    const FloorEffect::Number& number = effect.numbers[i];
    index = i > 0 && effect.numbers[i - 1].key == number.key ? index + 1 : 0;
    values.push_back(numberOf(params, number.key, index, effect.neutral[i] + number.shown_offset) -
                     number.shown_offset);
  }
  effect.apply(robot.model, values);
}

Eigen::Vector3d comOf(const twin::Model& model, Joint joint) {
  for (const Limb& limb : limbsOf(model))
    for (const Link& link : limb)
      if (link.joint == joint) return link.com_m;
  return Eigen::Vector3d::Zero();
}

/// x, y and z of a link are one list in an answer: the shift, or the place in the link's frame of a mass.
void addToLink(AnsweredRobot& robot, const MechanicalEffect& effect, Joint joint, const json& params,
               const twin::Model& model) {
  const bool is_mass = effect.numbers.front().unit == "kg";
  const Eigen::Vector3d com = is_mass ? comOf(model, joint) : Eigen::Vector3d{Eigen::Vector3d::Zero()};
  std::vector<double> values;
  std::size_t axis = 0;
  for (const MechanicalEffect::Number& number : effect.numbers) {
    if (number.unit != "m") {
      values.push_back(numberOf(params, number.key, 0, number.neutral));
      continue;
    }
    const double offset = com[static_cast<Eigen::Index>(axis)];
    values.push_back(numberOf(params, is_mass ? "point" : "shift", axis++, offset + number.neutral) - offset);
  }
  effect.apply(robot.model.robot.robot, joint, values);
}

void addMechanics(AnsweredRobot& robot, const MechanicalEffect& effect, const json& answer, const twin::Model& model) {
  const json& params = answer.at("params");
  for (const Joint joint : jointsAt(answer.at("at"))) {
    if (effect.is_of_link) {
      addToLink(robot, effect, joint, params, model);
      continue;
    }
    const BodyHypothesis& now = robot.model.robot.robot;
    std::vector<double> values = effect.values_in(now, joint);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string key{effect.numbers[i].key};
      if (!effect.numbers[i].is_addition) {
        values[i] = numberOf(params, key, 0, values[i]);
        continue;
      }
      const double own = ownNumber(now, effect, joint);
      values[i] = numberOf(params, key + std::string{kAddedEnding}, 0, numberOf(params, key, 0, own) - own);
    }
    effect.apply(robot.model.robot.robot, joint, values);
  }
}

}  // namespace

AnsweredRobot unchangedRobot(const twin::Model& model) {
  BodyCase given;
  given.joints.model = model;
  return {.model = {.robot = {.robot = {bodyBaselineOf(given), {}}, .floor = {}}}};
}

std::vector<Joint> jointsAt(const json& at) {
  std::vector<Joint> joints;
  if (at == "all") {
    joints.resize(kJoints);
    for (std::size_t i = 0; i < kJoints; ++i) joints[i] = static_cast<Joint>(i);
    return joints;
  }
  for (const json& name : at.is_array() ? at : json::array({at})) {
    const auto joint = findJoint(name.get<std::string>());
    if (!joint) throw std::runtime_error("there is no joint " + name.dump());
    joints.push_back(*joint);
  }
  return joints;
}

void addEffect(AnsweredRobot& robot, const json& effect, const twin::Model& model) {
  const std::string id = effect.at("id");
  const json& at = effect.at("at");
  const json& params = effect.at("params");
  if (id == kBatteryResistance) {
    robot.battery_ohm += params.at("resistance").get<double>();
    return;
  }
  std::vector<std::string_view> known{kBatteryResistance};
  for (const SensorEffect& one : sensorEffects()) {
    known.push_back(one.id);
    if (one.id == id) return applyTo(robot.model.imu, one, params.at(std::string{one.parameter}));
  }
  const std::vector<FloorEffect> of_floor = floorEffects(model);
  for (const FloorEffect& one : of_floor) {
    known.push_back(one.id);
    if (one.id == id && at == std::string{one.at}) return addFloor(robot, one, params);
  }
  for (const MechanicalEffect& one : mechanicalEffects()) {
    known.push_back(one.id);
    if (one.id == id) return addMechanics(robot, one, effect, model);
  }
  throw std::runtime_error("there is no effect " + id + " at " + at.dump() + "; " + text::suggestion(id, known));
}

}  // namespace darwinop::gap
