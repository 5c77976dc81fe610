#include "gap/localize/body/body_nuisances.hpp"

#include <algorithm>

#include "gap/plant/body/joint_alone.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

std::vector<double> valuesAt(const BodyHypothesis& robot, const twin::EffectInfo& effect, Joint joint) {
  const Hypothesis alone = atJoint(robot.servos, joint);
  const twin::EffectSetting* const now = alone.find(effect.id);
  return now == nullptr ? std::vector<double>{} : now->values;
}

/// Friction of one joint by a factor: the setting of its own replaces that of all joints.
void scaleFriction(BodyHypothesis& robot, const twin::EffectInfo& effect, Joint joint, double factor) {
  const Place own{.kind = Place::Kind::kJoint, .name = std::string{row(joint).name}};
  std::vector<double> values = valuesAt(robot, effect, joint);
  if (values.empty()) return;
  values[0] *= std::max(thresholds::kLeastPriorShare, factor);
  robot.servos.with(effect, own).values = std::move(values);
}

using Number = double twin::ServoParameters::*;

}  // namespace

std::vector<BodyNuisance> nuisancesOf(const BodyCase& given, const Limb& limb) {
  std::vector<BodyNuisance> out;
  const auto servo = [&](const char* key, const char* name, Number number) {
    const double sigma = given.sigmaOf(key);
    if (sigma > 0)
      out.push_back({name, [number, sigma](BodyHypothesis& robot, double sigmas) {
                       robot.servos.servo.*number *= 1 + sigmas * sigma;
                     }});
  };
  servo("servo", "kt", &twin::ServoParameters::kt_nm_a);
  servo("servo", "resistance", &twin::ServoParameters::resistance_ohm);
  servo("servo", "back_emf", &twin::ServoParameters::back_emf_vs_rad);
  servo("servo.duty_per_kp", "duty_per_kp", &twin::ServoParameters::duty_per_kp_per_rad);
  servo("servo.armature", "armature", &twin::ServoParameters::armature_kgm2);
  for (const Link& link : limb) {
    const Joint joint = link.joint;
    const std::string name{row(joint).name};
    if (const double sigma = given.sigmaOf("friction"); sigma > 0)
      for (const auto role : {twin::ParameterRole::kDryFriction, twin::ParameterRole::kViscousFriction}) {
        const twin::EffectInfo& effect = *twin::effectWith(role);
        const std::vector<double> believed = valuesAt({.servos = bodyBaselineOf(given), .links = {}}, effect, joint);
        out.push_back({name + " " + std::string{effect.id},
                       [&effect, joint, sigma](BodyHypothesis& robot, double sigmas) {
                         scaleFriction(robot, effect, joint, 1 + sigmas * sigma);
                       },
                       [&effect, joint, believed](const BodyHypothesis& robot) {
                         return valuesAt(robot, effect, joint) != believed;
                       },
                       believed.empty() ? std::string_view{} : effect.id, joint,
                       [believed, sigma](const std::vector<double>& added) { return added[0] / believed[0] / sigma; }});
      }
    if (const double sigma = given.sigmaOf("body.mass"); sigma > 0)
      out.push_back({name + " mass",
                     [joint, mass = link.mass_kg * sigma](BodyHypothesis& robot, double sigmas) {
                       robot.links.push_back({.link = joint, .mass_kg = sigmas * mass});
                     },
                     {},
                     "link_mass",
                     joint,
                     [mass = link.mass_kg * sigma](const std::vector<double>& values) { return values[0] / mass; }});
    if (const double sigma = given.sigmaOf("body.com_m"); sigma > 0)
      for (int axis = 0; axis < 3; ++axis)
        out.push_back({name + " centre of mass",
                       [joint, axis, sigma](BodyHypothesis& robot, double sigmas) {
                         LinkChange change{.link = joint};
                         change.com_shift_m[axis] = sigmas * sigma;
                         robot.links.push_back(change);
                       },
                       {},
                       "link_com",
                       joint,
                       [axis, sigma](const std::vector<double>& values) {
                         return values[static_cast<std::size_t>(axis)] / sigma;
                       }});
  }
  return out;
}

}  // namespace darwinop::gap
