#include "gap/export/body/body_holds.hpp"

#include <memory>
#include <optional>

#include "gap/plant/hypothesis.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"
#include "twin/servo/servo.hpp"

namespace darwinop::gap {
namespace {

using twin::approximated;
using twin::held;
using twin::lost;

constexpr Holding kOfSimulator = lost("it belongs to the simulator that reads the file; set it there");
constexpr Holding kNoSensor = lost("the format has no sensor; set it in the program that reads the file");
constexpr Holding kInProgram = lost("its sensor is ideal in this; change the readings in the controller");
constexpr Holding kRelativeNoise = lost("the noise of a lookupTable is a share of the value; add it in the controller");
constexpr Holding kNoJointSensors = lost("no sensors of joints are written");
constexpr Holding kArmatureBeside =
    lost("it is a comment at each joint; add it to the link's inertia, which then also resists other joints");
constexpr Holding kTurnedLink = approximated(
    "rotation of the joint's endPoint; add the offset to minPosition and maxPosition of its motor as well");
constexpr Holding kOneHinge = lost("the body has one hinge a joint");
constexpr Holding kNoBattery = lost("it has no supply voltage");
constexpr Holding kNoHolding = lost("a motor without a command is limp");

constexpr std::array<Holding, kTargets> inBody(Holding one) {
  return {one, one, one};
}
constexpr std::array<Holding, kTargets> ofSensor(Holding webots, Holding mujoco) {
  return {webots, mujoco, kNoSensor};
}

constexpr KeyHolding kKeys[] = {
    {"link", {"mass", inBody(held("mass, centre of mass and inertia of the link"))}},
    {"link", {"mass_from_com", inBody(held("mass, centre of mass and inertia of the link"))}},
    {"link", {"com_shift", inBody(held("mass, centre of mass and inertia of the link"))}},
    {"body", {"trunk_com", inBody(held("mass, centre of mass and inertia of the link"))}},
    {"body", {"trunk_inertia", inBody(held("mass, centre of mass and inertia of the link"))}},
    {"body", {"floor_friction", {held("coulombFriction"), held("friction of the contact pairs"), kOfSimulator}}},
    {"body",
     {"contact_time",
      {lost("softERP and softCFM depend on the masses that touch; fit them to a fall"),
       held("solref of the contact pairs"), kOfSimulator}}},
    {"body",
     {"sole_size",
      {held("size of the feet's boxes"), held("size of the feet's boxes"),
       lost("only inertias are written; scale the collision boxes of FootR and FootL")}}},
    {"body",
     {"floor_tilt_x", {held("rotation of the floor"), held("gravity, turned in place of the floor"), kOfSimulator}}},
    {"body",
     {"floor_tilt_y", {held("rotation of the floor"), held("gravity, turned in place of the floor"), kOfSimulator}}},
    {"body", {"battery_resistance", inBody(kNoBattery)}},
    {"body", {"self_collision", {held("selfCollision of the Robot"), held("collision and masks"), kOfSimulator}}},
    {"body", {"hold_until_driven", inBody(kNoHolding)}},
    {"body", {"step", {approximated("a basicTimeStep of whole milliseconds"), held("timestep"), kOfSimulator}}},
    {"imu", {"mounting", ofSensor(held("rotation of Gyro and Accelerometer"), held("orientation of the sites"))}},
    {"imu", {"gyro_range", ofSensor(held("ends of the lookupTable"), held("cutoff of the sensor"))}},
    {"imu", {"accel_range", ofSensor(held("ends of the lookupTable"), held("cutoff of the sensor"))}},
    {"imu", {"gyro_noise", ofSensor(kRelativeNoise, held("noise of the sensor, per step"))}},
    {"imu", {"accel_noise", ofSensor(kRelativeNoise, held("noise of the sensor, per step"))}},
    {"imu", {"gyro_bias", ofSensor(kInProgram, kInProgram)}},
    {"imu", {"accel_bias", ofSensor(kInProgram, kInProgram)}},
    {"imu", {"gyro_scale", ofSensor(kInProgram, kInProgram)}},
    {"imu", {"accel_scale", ofSensor(kInProgram, kInProgram)}},
    {"imu", {"gyro_axes", ofSensor(kInProgram, kInProgram)}},
    {"imu", {"accel_axes", ofSensor(kInProgram, kInProgram)}},
    {"imu", {"gyro_lowpass", ofSensor(kInProgram, kInProgram)}},
    {"imu", {"delay", ofSensor(kInProgram, kInProgram)}},
};

/// Of a number of the servo, where the file of a body differs from that of one joint.
Holding holdingInBody(const HoldingRow& row, Target target) {
  const Holding of_joint = row.of(target);
  if (row.what == kEncoderSteps) return kNoJointSensors;
  if (row.what == kArmature && of_joint.fate == Fate::kApproximated) return kArmatureBeside;
  return of_joint;
}

/// Likewise of an effect, by what it does to a servo.
Holding holdingInBody(const twin::EffectSetting& effect, const twin::ServoParameters& parameters, Target target) {
  std::vector<std::unique_ptr<twin::Effect>> alone;
  alone.push_back(effect.info->make(effect.values));
  const twin::Servo servo{parameters, std::move(alone)};
  const Holding of_joint = holdingOf(*effect.info).of(target);
  if (target == Target::kMujoco && servo.softGear()) return kOneHinge;
  if (twin::indexOf(*effect.info, twin::ParameterRole::kEncoderTicks)) return kNoJointSensors;
  if (of_joint.fate == Fate::kApproximated && servo.load().armature_kgm2 != 0) return kArmatureBeside;
  if (target == Target::kWebots && servo.load().angle_offset_rad != 0) return kTurnedLink;
  return of_joint;
}

/// [section] key = value of every key that is not as usual.
std::vector<std::string> changedIn(const twin::Model& model, const KeyHolding& holding) {
  const twin::Model usual;
  std::vector<std::string> out;
  for (const twin::KeyRow& row : twin::keyTable()) {
    const std::string_view kind = row.section.substr(0, row.section.find(' '));
    const std::string value = twin::writeValue(model, row);
    if (kind == holding.section && row.key == holding.row.what && value != twin::writeValue(usual, row))
      out.push_back("[" + std::string{row.section} + "] " + std::string{row.key} + " = " + value);
  }
  return out;
}

}  // namespace

std::span<const KeyHolding> keyHoldings() {
  return kKeys;
}

void addBodyLosses(Target target, const twin::Model& model, Export& out) {
  for (const KeyHolding& holding : kKeys)
    for (const std::string& what : changedIn(model, holding)) addLoss(target, what, holding.row.of(target), out);
  const Hypothesis servo{.servo = model.servo, .effects = {}, .pendulum = {}, .payload_scale = 1};
  for (const HoldingRow& row : numberHoldings())
    if (row.applies(servo)) addLoss(target, std::string{row.what}, holdingInBody(row, target), out);
  for (const twin::EffectInfo* const info : twin::catalogue()) {
    std::string joints;
    std::optional<Holding> holding;
    for (const twin::EffectSetting& effect : model.effects) {
      if (effect.info != info) continue;
      joints += (joints.empty() ? "" : ", ") + (effect.joint ? std::string{row(*effect.joint).name} : "all joints");
      const Holding here = holdingInBody(effect, model.servo, target);
      if (!holding || here.fate > holding->fate) holding = here;
    }
    if (holding) addLoss(target, std::string{info->id} + " (" + joints + ")", *holding, out);
  }
}

std::string keyHoldingsAsMarkdown() {
  std::vector<HoldingRow> rows;
  for (const KeyHolding& holding : kKeys) rows.push_back(holding.row);
  return holdingTable("Keys of `[link]`, `[body]`, `[imu]`", rows, "`");
}

}  // namespace darwinop::gap
