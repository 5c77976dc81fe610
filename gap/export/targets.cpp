#include "gap/export/targets.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text/number_text.hpp"
#include "gap/export/holds.hpp"
#include "gap/export/texts.hpp"
#include "twin/model/number.hpp"

namespace darwinop::gap {
namespace {

bool isNeutral(const twin::EffectSetting& effect) {
  for (std::size_t i = 0; i < effect.values.size(); ++i)
    if (effect.values[i] != effect.info->parameters[i].neutral) return false;
  return true;
}

/// "stribeck (friction = 0.05 N m, speed = 0.2 rad/s)"
std::string described(const twin::EffectSetting& effect) {
  std::string text;
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    const twin::Parameter& parameter = effect.info->parameters[i];
    text += (i == 0 ? "" : ", ") + std::string{parameter.key} + " = " + shortest(effect.values[i]);
    if (!parameter.unit.empty()) text += " " + std::string{parameter.unit};
  }
  return std::string{effect.info->id} + " (" + text + ")";
}

/// Of one effect of a hypothesis: a second hinge of MuJoCo that bends has no play.
Holding holdingIn(const Hypothesis& hypothesis, const PlacedEffect& effect, Target target,
                  const Conditions& conditions) {
  constexpr Holding kNoThirdHinge = twin::lost("the second hinge is the flex, and the play would take a third one");
  Hypothesis alone = hypothesis;
  alone.effects = {effect};
  const bool bends = std::isfinite(numbersOf(hypothesis, conditions).flex_nm_rad);
  if (target == Target::kMujoco && bends && numbersOf(alone, conditions).play_rad > 0) return kNoThirdHinge;
  return holdingOf(*effect.info).of(target);
}

std::string write(Target target, const JointText& joint) {
  switch (target) {
    case Target::kWebots:
      return webotsText(joint, webotsFields(joint.servo));
    case Target::kMujoco:
      return mujocoText(joint, mujocoFields(joint.servo, joint.arm.inertia_kgm2, joint.settings.stepOf(target)));
    case Target::kUrdf:
      return urdfText(joint, urdfFields(joint.servo));
  }
  return {};
}

}  // namespace

void checkSettings(Target target, const ExportSettings& settings) {
  const auto allowed = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '-';
  };
  if (settings.joint.empty() || !std::ranges::all_of(settings.joint, allowed))
    throw std::runtime_error("export: the joint's name is \"" + settings.joint +
                             "\"; use letters, digits, '_' and '-', as in ArmUpperR");
  if (!(settings.p_register >= 1 && settings.p_register <= 254))
    throw std::runtime_error("export: P register = " + shortest(settings.p_register) +
                             "; 1 to 254 are allowed, and 32 is the servo's own");
  const double step_s = settings.stepOf(target);
  if (!(step_s >= 1e-5 && step_s <= 0.1))
    throw std::runtime_error("export: a time step of " + shortest(step_s) + " s; 0.00001 to 0.1 s are allowed, and " +
                             std::string{infoOf(target).title} + "'s usual one is " + shortest(infoOf(target).step_s) +
                             " s");
}

void addLoss(Target target, const std::string& what, const Holding& holding, Export& out) {
  const std::string title{infoOf(target).title}, how{holding.how};
  if (holding.fate == Fate::kLost) out.lost.push_back(title + " loses " + what + ": " + how + ".");
  if (holding.fate == Fate::kApproximated)
    out.approximated.push_back(title + " approximates " + what + " as " + how + ".");
}

double JointText::ownInertia() const {
  constexpr double kLeast = 1e-9;  // kg m2; MuJoCo refuses bodies without
  return std::max(kLeast, arm.inertia_kgm2 - arm.mass_kg * arm.com_m * arm.com_m);
}

double JointText::mass() const {
  constexpr double kLeast = 1e-9;  // kg
  return std::max(kLeast, arm.mass_kg);
}

std::string shortest(double value) {
  return text::shortestText(value == 0 ? 0.0 : value);  // no -0
}

std::string attribute(std::string_view key, double value) {
  return " " + std::string{key} + "=\"" + shortest(value) + "\"";
}

std::string xmlComments(const std::vector<std::string>& lines, std::string_view indent) {
  std::string text;
  for (std::string line : lines) {
    for (auto at = line.find("--"); at != line.npos; at = line.find("--")) line.replace(at, 2, "- -");  // ends one
    text += std::string{indent} + "<!-- " + line + " -->\n";
  }
  return text;
}

Export exportTo(Target target, const Hypothesis& hypothesis, const ExportSettings& settings) {
  checkSettings(target, settings);
  Export out;
  for (const HoldingRow& row : numberHoldings())
    if (row.applies(hypothesis)) addLoss(target, std::string{row.what}, row.of(target), out);
  for (const PlacedEffect& effect : hypothesis.effects)
    if (!isNeutral(effect))
      addLoss(target, described(effect), holdingIn(hypothesis, effect, target, settings.conditions()), out);

  JointText joint{.settings = settings,
                  .servo = numbersOf(hypothesis, settings.conditions()),
                  .arm = armOf(hypothesis, settings.payload_kg),
                  .head = {},
                  .foot = {}};
  joint.head = {"Joint " + settings.joint + " of " + settings.model + ", written by darwinop gap export for " +
                    std::string{infoOf(target).title} + ".",
                "All numbers are SI and seen at the horn: rad, N m, kg m2. Taken at P register " +
                    shortest(settings.p_register) + " and " + shortest(settings.temperature_c) +
                    " degC; another P or " + "heat needs another export."};
  joint.foot = out.approximated;
  joint.foot.insert(joint.foot.end(), out.lost.begin(), out.lost.end());
  out.text = write(target, joint);
  return out;
}

}  // namespace darwinop::gap
