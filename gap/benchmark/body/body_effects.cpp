#include "gap/benchmark/body/body_effects.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/text/nearest.hpp"
#include "gap/benchmark/body/drawn_sizes.hpp"
#include "gap/benchmark/body/outside_effects.hpp"
#include "gap/identify/body/battery.hpp"
#include "gap/identify/body/floor_effect.hpp"
#include "gap/identify/body/mechanical_effect.hpp"
#include "gap/identify/body/sensor_effect.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

// Ids that other suites use for what the catalogue of servos has.
constexpr std::string_view kBusLatency = "bus_latency", kTransportDelay = "transport_delay",
                           kBattery = kBatteryResistance;

const SensorEffect* restingEffect(const std::string& id) {
  const auto all = sensorEffects();
  const auto found = std::ranges::find(all, id, &SensorEffect::id);
  return found == all.end() ? nullptr : &*found;
}

void hideFloor(const std::string& id, const BodyCase& plan, Rng& rng, BodyTruth& truth, BodyKey& key) {
  const std::vector<FloorEffect> all = floorEffects(plan.joints.model);
  const FloorEffect& effect = *std::ranges::find(all, id, &FloorEffect::id);
  const Values drawn = drawnFor(id, rng);
  std::vector<double> values;
  for (const auto& [name, of] : drawn) values.insert(values.end(), of.begin(), of.end());
  effect.apply(truth.model, values);
  key.effects.push_back({id, {std::string{effect.at}}, drawn});
}

void hideResting(const SensorEffect& effect, Rng& rng, BodyTruth& truth, BodyKey& key) {
  const Values drawn = drawnFor(std::string{effect.id}, rng);
  applyTo(truth.model.imu, effect, drawn.begin()->second);
  key.effects.push_back({std::string{effect.id}, {std::string{effect.at}}, drawn});
}

void hideMass(const std::string& id, Rng& rng, BodyTruth& truth, BodyKey& key) {
  const bool is_mass = id == "link_mass";
  std::vector<double> shift = oneAxis(rng, 0, 0.01, 0.02);
  const Eigen::Vector3d by{shift[0], shift[1], shift[2]};
  if (rng.uniform() < 0.4) {
    FloorChange& floor = truth.model.robot.floor;
    if (is_mass)
      floor.trunk_mass_kg = rng.between(0.15, 0.4), floor.trunk_from_com_m = 2 * by;
    else
      floor.trunk_com_shift_m = by;
    key.effects.push_back({id, {"Body"}, is_mass ? Values{{"mass", {floor.trunk_mass_kg}}} : Values{{"shift", shift}}});
    return;
  }
  // Links that are long enough to show it.
  constexpr std::array kLinks{Joint::kArmUpperR, Joint::kArmLowerR, Joint::kArmLowerL, Joint::kLegUpperL,
                              Joint::kLegLowerR, Joint::kFootR,     Joint::kFootL,     Joint::kHead};
  LinkChange change{.link = rng.pick(kLinks)};
  if (is_mass)
    change.mass_kg = rng.between(0.04, 0.1), change.from_com_m = rng.coin() ? by : Eigen::Vector3d{0, 0, 0};
  else
    change.com_shift_m = by;
  truth.model.robot.robot.links.push_back(change);
  key.effects.push_back({id,
                         {std::string{row(change.link).name}},
                         is_mass ? Values{{"mass", {change.mass_kg}}} : Values{{"shift", shift}}});
}

const MechanicalEffect& mechanicalEffect(std::string_view id) {
  return *std::ranges::find(mechanicalEffects(), id, &MechanicalEffect::id);
}

/// A number that suites of a single servo draw, such as count and phase of a ripple.
std::optional<double> drawnNumber(std::string_view id, std::size_t number, Rng& rng) {
  for (const twin::DrawnParameter& drawn : twin::findEffect(id)->synthetic.drawn)
    if (drawn.parameter == number)
      return drawn.choices.empty() ? rng.between(drawn.low, drawn.high) : rng.pick(drawn.choices);
  return {};
}

/// The same values in all of the joints; an addition comes on top of each one's own number.
std::vector<double> drawnValues(const MechanicalEffect& effect, const std::vector<double>& now, Rng& rng) {
  const double strength = rng.between(1, 2);
  std::vector<double> values = now;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const MechanicalEffect::Number& number = effect.numbers[i];
    // A limit gets tighter the further it is from neutral.
    const bool is_limit = number.is_logarithmic && std::abs(number.typical) < std::abs(number.neutral);
    const double grown = values[i] + strength * (number.typical - number.neutral);
    const double value = is_limit ? number.typical / strength : grown;
    values[i] = std::clamp(number.is_secondary ? number.typical : value, number.low, number.high);
    values[i] = drawnNumber(effect.id, i, rng).value_or(values[i]);
  }
  return values;
}

void hideInJoints(const std::string& id, std::vector<Joint> joints, Rng& rng, BodyTruth& truth, BodyKey& key) {
  const MechanicalEffect& effect = mechanicalEffect(id == kBusLatency ? kTransportDelay : std::string_view{id});
  BodyHypothesis& robot = truth.model.robot.robot;
  const std::vector<double> values = drawnValues(effect, effect.values_in(robot, joints.front()), rng);
  Values of_key;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string name{effect.numbers[i].key};
    if (!effect.numbers[i].is_addition) {
      of_key[name] = {values[i]};
      continue;
    }
    of_key[name + std::string{kAddedEnding}] = {values[i]};
    const auto own = [&](Joint joint) { return ownNumber(robot, effect, joint); };
    const double total = own(joints.front()) + values[i];
    if (std::ranges::all_of(joints, [&](Joint joint) { return own(joint) == own(joints.front()); }))
      of_key[name] = {total};
  }
  for (const Joint joint : joints) effect.apply(robot, joint, values);
  std::vector<std::string> at;
  for (const Joint joint : joints) at.emplace_back(row(joint).name);
  if (joints.size() == kJoints) at = {"all"};
  key.effects.push_back({id, id == kBusLatency ? std::vector<std::string>{"all"} : at, of_key});
}

std::vector<Joint> drawnJoints(BodyClass kind, Rng& rng) {
  std::vector<Joint> out;
  if (kind == BodyClass::kPair) {
    const auto right = static_cast<Joint>(2 * rng.below(9));
    return {right, *leftOf(right)};
  }
  if (kind == BodyClass::kOneJoint) return {static_cast<Joint>(rng.below(kJoints))};
  for (std::size_t i = 0; i < kJoints; ++i) out.push_back(static_cast<Joint>(i));
  return out;
}

}  // namespace

const std::vector<BodyEffect>& bodyEffects() {
  static const std::vector<BodyEffect> kAll = [] {
    std::vector<BodyEffect> out;
    const auto add = [&](std::string_view id, BodyClass kind) { out.push_back({std::string{id}, kind}); };
    for (const SensorEffect& effect : sensorEffects()) add(effect.id, BodyClass::kSensor);
    for (const FloorEffect& effect : floorEffects(twin::readModel(twin::findModel("darwin-op"))))
      if (effect.at != "Body") add(effect.id, effect.is_of_sensor ? BodyClass::kSensor : BodyClass::kContact);
    for (const MechanicalEffect& effect : mechanicalEffects()) {
      if (effect.is_of_link) add(effect.id, BodyClass::kMass);
      if (effect.is_of_link) continue;
      for (const BodyClass kind : {BodyClass::kOneJoint, BodyClass::kPair, BodyClass::kAll}) add(effect.id, kind);
    }
    add(kBattery, BodyClass::kBus), add(kBusLatency, BodyClass::kBus);
    for (const std::string_view id : kOutsideEffects) add(id, BodyClass::kOutside);
    return out;
  }();
  return kAll;
}

BodyEffect bodyEffectCalled(const std::string& text) {
  const std::size_t at = text.find('@');
  const std::string id = text.substr(0, at), where = at == std::string::npos ? "" : text.substr(at + 1);
  std::vector<std::string_view> known;
  for (const BodyEffect& effect : bodyEffects()) {
    known.push_back(effect.id);
    const bool is_there = where.empty() || (where == "pair" && effect.kind == BodyClass::kPair) ||
                          (where == "all" && effect.kind == BodyClass::kAll);
    if (effect.id == id && is_there) return effect;
  }
  throw std::runtime_error("there is no effect " + text + " of a whole robot to hide; " + text::suggestion(id, known) +
                           "; an effect of a servo may have @pair or @all");
}

void hide(const BodyEffect& effect, const BodyCase& plan, Rng& rng, BodyTruth& truth, BodyKey& key) {
  if (effect.kind == BodyClass::kOutside) return hideOutside(effect.id, plan, rng, truth, key);
  if (effect.kind == BodyClass::kMass) return hideMass(effect.id, rng, truth, key);
  if (const SensorEffect* const resting = restingEffect(effect.id)) return hideResting(*resting, rng, truth, key);
  if (effect.kind == BodyClass::kSensor || effect.kind == BodyClass::kContact)
    return hideFloor(effect.id, plan, rng, truth, key);
  if (effect.id == kBattery) {
    truth.battery_ohm = rng.between(0.1, 0.35);
    key.effects.push_back({effect.id, {"battery"}, {{"resistance", {truth.battery_ohm}}}});
    return;
  }
  hideInJoints(effect.id, drawnJoints(effect.kind, rng), rng, truth, key);
}

}  // namespace darwinop::gap
