#include "gap/plan/body/rival_models.hpp"

#include "core/text/joined.hpp"
#include "gap/plan/thresholds.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
namespace {

constexpr const char* kAsItIs = "nothing missing";

/// What was found, with one of its parts replaced.
struct Parts {
  std::vector<SensorFit> sensors;
  std::vector<PlacedMechanics> mechanics;
  FloorSet floor;

  [[nodiscard]] FloorModel on(const BodyCase& given) const {
    FloorModel out{.robot = {.robot = declaredRobot(given), .floor = {}}};
    for (const SensorFit& one : sensors) {
      if (one.effects.empty()) continue;
      (one.effects.front()->sensor == ImuSensor::kGyro ? out.imu.gyro : out.imu.accel) = one.deviation;
    }
    for (const PlacedMechanics& one : mechanics) one.applyTo(out.robot.robot);
    for (const PlacedFloor& one : floor) one.effect->apply(out, one.values);
    return out;
  }
};

Parts partsOf(const BodyIdentification& found) {
  Parts out;
  for (const SensorSelection& one : found.sensors) out.sensors.push_back(one.found);
  for (const FoundMechanics& one : found.mechanics.found) out.mechanics.push_back(one.placed);
  for (const FoundFloor& one : found.floor.found) out.floor.push_back(one.placed);
  return out;
}

std::string nameOf(const SensorFit& fit) {
  std::vector<std::string> ids;
  for (const SensorEffect* const effect : fit.effects)
    ids.push_back(std::string{effect->id} + " " + std::string{effect->at});
  return ids.empty() ? kAsItIs : text::joined(ids, " + ");
}

std::string nameOf(const PlacedMechanics& placed) {
  std::vector<std::string> at;
  for (const Joint joint : placed.joints) at.emplace_back(row(joint).name);
  return std::string{placed.effect->id} + " " + (at.size() == kJoints ? "all" : text::joined(at, "+"));
}

std::string nameOf(const PlacedFloor& placed) {
  return std::string{placed.effect->id} + " " + std::string{placed.effect->at};
}

/// The first ambiguity: the nearest rivals alone, since each further model costs simulations of every motion.
void addRivals(const BodyCase& given, const BodyIdentification& found, std::vector<RivalModel>& out) {
  const Parts parts = partsOf(found);
  const auto add = [&](auto Parts::*list, std::size_t at, const auto& now, const auto& rivals) {
    out.push_back({nameOf(now), parts.on(given)});
    for (const auto& rival : rivals) {
      if (out.size() == thresholds::kMostPlannedRivals) break;
      Parts other = parts;
      (other.*list)[at] = rival;
      out.push_back({nameOf(rival), other.on(given)});
    }
  };
  for (std::size_t i = 0; i < found.sensors.size(); ++i)
    if (out.empty() && !found.sensors[i].rivals.empty())
      add(&Parts::sensors, i, found.sensors[i].found, found.sensors[i].rivals);
  for (std::size_t i = 0; i < found.mechanics.found.size(); ++i)
    if (const FoundMechanics& one = found.mechanics.found[i]; out.empty() && !one.rivals.empty())
      add(&Parts::mechanics, i, one.placed, one.rivals);
  for (std::size_t i = 0; i < found.floor.found.size(); ++i)
    if (const FoundFloor& one = found.floor.found[i]; out.empty() && !one.rivals.empty())
      add(&Parts::floor, i, one.placed, one.rivals);
}

void addTried(const BodyCase& given, const BodyIdentification& found, std::vector<RivalModel>& out) {
  const Parts parts = partsOf(found);
  const auto add = [&](auto Parts::*list, const auto& tried) {
    for (const auto& one : tried) {
      if (out.size() >= thresholds::kMostPlannedRivals) return;
      if (out.empty()) out.push_back({kAsItIs, parts.on(given)});
      Parts with = parts;
      (with.*list).push_back(one);
      out.push_back({nameOf(one), with.on(given)});
    }
  };
  add(&Parts::mechanics, found.mechanics.tried);
  add(&Parts::floor, found.floor.tried);
}

void addRevealed(const BodyCase& given, const BodyIdentification& found, std::vector<RivalModel>& out) {
  const FloorModel now = partsOf(found).on(given);
  out.push_back({kAsItIs, now});
  for (const FloorEffect& effect : floorEffects(given.joints.model)) {
    RivalModel with{std::string{effect.id} + " " + std::string{effect.at}, now};
    effect.apply(with.model, effect.starts[effect.starts.size() / 2]);
    out.push_back(std::move(with));
  }
}

}  // namespace

BodyQuestion questionAfter(const BodyCase& given, const BodyIdentification& found) {
  BodyQuestion out;
  addRivals(given, found, out.models);
  if (out.models.empty() && found.verdict == Verdict::kUnknown) addTried(given, found, out.models);
  if (!out.models.empty()) return out;
  out.is_rivalry = false;
  addRevealed(given, found, out.models);
  return out;
}

}  // namespace darwinop::gap
