#include "gap/export/holds.hpp"

#include <algorithm>
#include <stdexcept>

namespace darwinop::gap {
namespace {

constexpr Holding held(std::string_view how) {
  return {Fate::kHeld, how};
}
constexpr Holding nearly(std::string_view how) {
  return {Fate::kApproximated, how};
}
constexpr Holding lost(std::string_view why) {
  return {Fate::kLost, why};
}

constexpr std::string_view kInTheBody = "in the body: mass and centre of mass of the link";
constexpr std::string_view kInTheLink = "inertia of the link, which then resists other joints, too";
constexpr std::string_view kTurnTheBody = "in the body: the link turned about its joint by the offset";
constexpr std::string_view kNoController = "the format has no controller; set it in the program that reads the file";
constexpr std::string_view kNoFrictionOfSpeed = "its dry friction is the same at every speed";
constexpr std::string_view kNoFrictionOfLoad = "its dry friction does not know the load";
constexpr std::string_view kDelayInController = "commands act in the same step; delay them in the controller";
constexpr std::string_view kNoSupply = "it knows no supply";
constexpr std::string_view kScaleInController = "multiply the goal in the controller";
constexpr std::string_view kSpeedMotor = "its P sets a speed, so a loaded joint always arrives";

// Webots, MuJoCo, URDF.
constexpr HoldingRow kEffects[] = {
    {"lost_packets",
     {lost("every command arrives; drop them in the controller"),
      lost("every command arrives; drop them in the controller"),
      lost("every command arrives; drop them in the controller")}},
    {"transport_delay", {lost(kDelayInController), lost(kDelayInController), lost(kDelayInController)}},
    {"gear_scale", {lost(kScaleInController), held("gainprm, the goal's factor"), lost(kScaleInController)}},
    {"speed_limit",
     {nearly("maxVelocity: it limits the motor, not the goal's way"),
      lost("a position actuator has no limit of speed; move the goal in the controller"),
      nearly("limit velocity: it limits the joint, not the goal's way")}},
    {"accel_limit",
     {nearly("acceleration: it limits the motor's speed, and braking begins when P asks for it"),
      lost("a position actuator has no limit of acceleration; move the goal in the controller"),
      lost("the format has no limit of acceleration")}},
    {"encoder_quantisation",
     {nearly("resolution of the PositionSensor; the motor's own loop sees the exact angle"),
      nearly("noise of the jointpos sensor, as large as the rounding; the actuator sees the exact angle"),
      lost("the format has no sensor of a joint")}},
    {"p_on_torque", {lost(kSpeedMotor), held("actuator: gainprm and biasprm"), lost(kNoController)}},
    {"deadband",
     {lost("controlPID has no dead band; keep the goal at the angle in the controller"),
      lost("an affine actuator has no dead band"), lost(kNoController)}},
    {"kp_scale", {nearly("controlPID, P of a speed"), held("actuator: gainprm and biasprm"), lost(kNoController)}},
    {"integral", {nearly("controlPID, I of a speed"), lost("an affine actuator has no integral"), lost(kNoController)}},
    {"derivative",
     {nearly("controlPID, D of a speed"), nearly("biasprm: brakes the joint; the goal's own speed is left out"),
      lost(kNoController)}},
    {"torque_limit",
     {nearly("maxTorque; a limit of the duty lowers maxVelocity too"),
      nearly("forcerange: exact for a limit of the duty; one of the torque acts before the back EMF"),
      nearly("limit effort; a limit of the duty lowers velocity too")}},
    {"coulomb",
     {nearly("staticFriction: brakes and holds the limp joint; a motor that moves by speed overcomes it unseen"),
      held("frictionloss"), held("dynamics friction")}},
    {"viscous",
     {nearly("dampingConstant: brakes the limp joint; a motor that moves by speed overcomes it unseen"),
      held("damping"), held("dynamics damping")}},
    {"stribeck", {lost(kNoFrictionOfSpeed), lost(kNoFrictionOfSpeed), lost(kNoFrictionOfSpeed)}},
    {"load_dependent_friction", {lost(kNoFrictionOfLoad), lost(kNoFrictionOfLoad), lost(kNoFrictionOfLoad)}},
    {"directional_load_friction", {lost(kNoFrictionOfLoad), lost(kNoFrictionOfLoad), lost(kNoFrictionOfLoad)}},
    {"quadratic_load_friction", {lost(kNoFrictionOfLoad), lost(kNoFrictionOfLoad), lost(kNoFrictionOfLoad)}},
    {"temp_drift",
     {nearly("friction and torque at one temperature, written beside them"),
      nearly("friction and torque at one temperature, written beside them"),
      nearly("friction and effort at one temperature, written beside them")}},
    {"kt_error",
     {nearly("maxTorque, maxVelocity and P"), held("actuator: kp, forcerange and the back EMF's biasprm"),
      nearly("limit effort and velocity")}},
    {"resistance_error",
     {nearly("maxTorque"), held("actuator: kp, forcerange and the back EMF's biasprm"), nearly("limit effort")}},
    {"supply_sag", {lost(kNoSupply), lost(kNoSupply), lost(kNoSupply)}},
    {"cogging",
     {lost("no torque of a joint depends on its angle alone; add it in a physics plug-in"),
      lost("no torque of a joint depends on its angle so; add it as qfrc_applied"),
      lost("no torque of a joint depends on its angle alone")}},
    {"backlash",
     {nearly("HingeJointWithBacklash, gap: hard stops; the sensor sits before the gap, the servo's behind it"),
      nearly("a second hinge with a range: soft stops; the actuator sees the angle before the gap"),
      lost("one joint has no play; it would take a second one with limits, which many readers drop")}},
    {"joint_flex",
     {lost("it would take a second hinge with a springConstant, which steps of 8 and 16 ms cannot follow"),
      held("a second hinge: stiffness and damping"), lost("a joint has no stiffness")}},
    {"com_mass", {held(kInTheBody), held(kInTheBody), held(kInTheBody)}},
    {"inertia", {nearly(kInTheLink), held("armature"), nearly(kInTheLink)}},
    {"encoder_offset", {held(kTurnTheBody), held(kTurnTheBody), held(kTurnTheBody)}},
};

bool pushes(const Hypothesis& h) {
  const twin::EffectSetting* const swapped = h.find("p_on_torque");
  return h.servo.law == twin::Law::kVoltageP || (swapped != nullptr && swapped->values[0] >= 0.5);
}

constexpr HoldingRow kNumbers[] = {
    {"P on torque (law voltage_p)",
     {lost(kSpeedMotor), held("actuator: gainprm and biasprm"), lost(kNoController)},
     pushes},
    {"P on speed (law speed_p)",
     {held("controlPID"),
      nearly("kd as firm as the step allows, kp = P kd; it gives way under load, and has no greatest speed"),
      lost(kNoController)},
     [](const Hypothesis& h) { return !pushes(h); }},
    {"back EMF: torque that falls with speed",
     {lost("the motor has all of maxTorque up to maxVelocity"), held("an actuator of its own: biasprm"),
      lost("a joint has all of its effort up to its velocity")},
     pushes},
    {"armature",
     {nearly(kInTheLink), held("armature"), nearly(kInTheLink)},
     [](const Hypothesis& h) { return h.servo.armature_kgm2 > 0; }},
    {"encoder's steps",
     {nearly("resolution of the PositionSensor; the motor's own loop sees the exact angle"),
      nearly("noise of the jointpos sensor; the actuator sees the exact angle"),
      lost("the format has no sensor of a joint")},
     [](const Hypothesis&) { return true; }},
    {"heat of the servo and its protection",
     {lost("it knows no heat"), lost("it knows no heat"), lost("it knows no heat")},
     [](const Hypothesis&) { return true; }},
};

/// One line per target: which of the rows it holds, approximates and loses.
std::string tableOf(std::string_view what, std::span<const HoldingRow> rows, std::string_view quote) {
  constexpr Fate kColumns[] = {Fate::kHeld, Fate::kApproximated, Fate::kLost};
  std::string text = "| " + std::string{what} + " |";
  for (const Fate fate : kColumns) text.append(" ").append(name(fate)).append(" |");
  text += "\n|---|---|---|---|\n";
  for (const TargetInfo& info : kTargetTable) {
    text.append("| ").append(info.title).append(" |");
    for (const Fate fate : kColumns) {
      std::string_view between = " ";
      for (const HoldingRow& row : rows) {
        if (row.of(info.target).fate != fate) continue;
        text.append(between).append(quote).append(row.what).append(quote);
        between = ", ";
      }
      text += " |";
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::span<const HoldingRow> effectHoldings() {
  return kEffects;
}

std::span<const HoldingRow> numberHoldings() {
  return kNumbers;
}

const HoldingRow& holdingOf(std::string_view effect) {
  const auto* const found = std::ranges::find(kEffects, effect, &HoldingRow::what);
  if (found == std::ranges::end(kEffects))
    throw std::logic_error("gap/export/holds.cpp says of no target what becomes of the effect " + std::string{effect});
  return *found;
}

std::string_view name(Fate fate) {
  constexpr std::string_view kNames[] = {"held", "approximated", "lost"};
  return kNames[static_cast<std::size_t>(fate)];
}

std::string holdingsAsMarkdown() {
  return tableOf("Effects", kEffects, "`") + "\n" + tableOf("Numbers of the servo", kNumbers, "");
}

}  // namespace darwinop::gap
