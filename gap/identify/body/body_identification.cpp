#include "gap/identify/body/body_identification.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "gap/localize/body/close_by_numbers.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
namespace {

Verdict verdictOf(const BodyIdentification& of) {
  const auto has_rivals = [](const auto& one) { return !one.rivals.empty(); };
  const auto is_named = [](const SensorSelection& one) { return !one.found.effects.empty(); };
  if (std::ranges::any_of(of.sensors, has_rivals) || std::ranges::any_of(of.mechanics.found, has_rivals) ||
      std::ranges::any_of(of.floor.found, has_rivals))
    return Verdict::kAmbiguous;
  if (std::ranges::any_of(of.sensors, is_named) || !of.mechanics.found.empty() || !of.floor.found.empty() || of.battery)
    return Verdict::kNamed;
  if (of.table.open() > 0) return Verdict::kUnknown;
  return of.table.not_tested.empty() ? Verdict::kNone : Verdict::kCannotTell;
}

/// What clamped logs have shown.
ImuDeviation sensorsOf(const BodyIdentification& found) {
  ImuDeviation out;
  for (const SensorSelection& one : found.sensors)
    (one.sensor == ImuSensor::kGyro ? out.gyro : out.accel) = one.found.deviation;
  return out;
}

/// The model with all that clamped logs have shown.
FloorModel clampedModel(const ClampedRobot& robot, const BodyIdentification& found) {
  std::vector<PlacedMechanics> effects;
  for (const FoundMechanics& one : found.mechanics.found) effects.push_back(one.placed);
  return {.robot = {.robot = with(robot, effects), .floor = {}}, .imu = sensorsOf(found)};
}

/// With all that was found.
FloorModel finalModel(const ClampedRobot& robot, const BodyIdentification& found) {
  FloorModel out = clampedModel(robot, found);
  for (const FoundFloor& one : found.floor.found) one.placed.effect->apply(out, one.placed.values);
  return out;
}

/// Joints of limbs that clamped logs leave unexplained.
std::vector<Joint> unexplainedJoints(const ClampedRobot& robot, const MechanicsSelection& mechanics) {
  std::vector<Joint> out;
  for (const Limb& limb : robot.limbs()) {
    const bool is_open = std::ranges::any_of(limb, [&](const Link& link) {
      return std::ranges::any_of(mechanics.rows, [&](const BodyRow& row) {
        return row.open && row.place.name == kJointTable[static_cast<std::size_t>(link.joint)].name;
      });
    });
    if (!is_open) continue;
    for (const Link& link : limb) out.push_back(link.joint);
  }
  return out;
}

/// Joints and recordings without contact come first: what they do not explain in a leg acts on the whole robot.
bool carriesTheRobot(Joint joint) {
  return joint == Joint::kFootR || joint == Joint::kFootL;
}

}  // namespace

BodyIdentification identify(const BodyCase& given, BodyScope scope) {
  const auto begin = std::chrono::steady_clock::now();
  const RestingImu imu{given.joints.model};
  BodyIdentification out;
  if (scope == BodyScope::kSensors) {
    out.table = localize(given, imu);
    out.sensors = identifySensors(given, imu, out.table);
    out.held_out = heldOutGapAtRest(given, sensorsOf(out));
  } else {
    out.battery = identifyBattery(given);
    ClampedRobot robot{given, out.battery.has_value()};
    out.table = localize(given, imu, robot);
    std::vector<std::size_t> limbs(robot.limbs().size());
    std::iota(limbs.begin(), limbs.end(), std::size_t{0});
    if (closeByNumbers(robot, limbs, robot.baseline(), out.table.open_from)) out.table = localize(given, imu, robot);
    out.mechanics = identifyMechanics(robot, out.table);
    out.sensors = identifySensors(given, imu, out.table);
    const std::vector<Joint> unexplained = unexplainedJoints(robot, out.mechanics);
    const bool legs_are_explained = std::ranges::none_of(unexplained, carriesTheRobot);
    out.floor = legs_are_explained ? identifyFloor(given, clampedModel(robot, out), unexplained, out.table.rows.size())
                                   : identifyMovingGyro(given, clampedModel(robot, out));
    std::vector<BodyRow> rows = std::move(out.table.rows);
    rows.insert(rows.end(), out.floor.rows.begin(), out.floor.rows.end());
    out.table = tableOf(std::move(rows), given);
    if (!legs_are_explained && canSimulateFloor(given)) {
      std::erase(out.table.not_tested, kNoFloorSignals);
      out.table.not_tested.emplace_back(kLegNotExplained);
    }
    const FloorModel declared{.robot = {.robot = declaredRobot(given), .floor = {}}};
    out.held_out = heldOutGap(given, declared, finalModel(robot, out));
  }
  out.verdict = verdictOf(out);
  out.runtime_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace darwinop::gap
