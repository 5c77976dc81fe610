#include "gap/export/holds.hpp"

#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using twin::approximated;
using twin::held;
using twin::lost;

bool pushes(const Hypothesis& h) {
  return h.law() == twin::Law::kVoltageP;
}

constexpr HoldingRow kNumbers[] = {
    {kPOnTorque,
     {lost(twin::exports::kSpeedMotor), held("actuator: gainprm and biasprm"), lost(twin::exports::kNoController)},
     pushes},
    {"P on speed (law speed_p)",
     {held("controlPID"),
      approximated("kd as firm as the step allows, kp = P kd; it gives way under load, and has no greatest speed"),
      lost(twin::exports::kNoController)},
     [](const Hypothesis& h) { return !pushes(h); }},
    {"back EMF: torque that falls with speed",
     {lost("the motor has all of maxTorque up to maxVelocity"), held("an actuator of its own: biasprm"),
      lost("a joint has all of its effort up to its velocity")},
     pushes},
    {kArmature,
     {approximated(twin::exports::kInTheLink), held("armature"), approximated(twin::exports::kInTheLink)},
     [](const Hypothesis& h) { return h.servo.armature_kgm2 > 0; }},
    {kEncoderSteps,
     {approximated("resolution of the PositionSensor; the motor's own loop has the exact angle"),
      approximated("noise of the jointpos sensor; the actuator has the exact angle"),
      lost("the format has no sensor of a joint")},
     [](const Hypothesis&) { return true; }},
    {"heat of the servo and its protection",
     {lost("it has no thermal model"), lost("it has no thermal model"), lost("it has no thermal model")},
     [](const Hypothesis&) { return true; }},
};

}  // namespace

std::vector<HoldingRow> effectHoldings() {
  std::vector<HoldingRow> rows;
  for (const twin::EffectInfo* const effect : twin::catalogue()) rows.push_back(holdingOf(*effect));
  return rows;
}

std::span<const HoldingRow> numberHoldings() {
  return kNumbers;
}

HoldingRow holdingOf(const twin::EffectInfo& effect) {
  return {effect.id, {effect.exports.webots, effect.exports.mujoco, effect.exports.urdf}};
}

std::string_view name(Fate fate) {
  constexpr std::string_view kNames[] = {"held", "approximated", "lost"};
  return kNames[static_cast<std::size_t>(fate)];
}

std::string holdingTable(std::string_view what, std::span<const HoldingRow> rows, std::string_view quote) {
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

std::string holdingsAsMarkdown() {
  return holdingTable("Effects", effectHoldings(), "`") + "\n" + holdingTable("Numbers of the servo", kNumbers, "");
}

}  // namespace darwinop::gap
