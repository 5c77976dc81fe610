// What was found at one servo, in the sections of a robot's model.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gap/report/addition.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

/// The joint and those that it carries: a chain is listed from the trunk outwards.
std::vector<Joint> outwardsOf(Joint joint) {
  std::vector<Joint> joints;
  for (std::size_t i = static_cast<std::size_t>(joint); i < kJoints; ++i)
    if (kJointTable[i].chain == row(joint).chain) joints.push_back(static_cast<Joint>(i));
  return joints;
}

/// By what factor a shift of all masses of the bench changes their moment.
double momentFactor(const Case& given, double shift_m) {
  const twin::Pendulum arm = armOf(given, given.logs.front());
  const double moment = (arm.payload_kg + arm.arm_mass_kg / 2) * arm.length_m;
  return 1 + shift_m * (arm.payload_kg + arm.arm_mass_kg) / moment;
}

AddedValue* valueOf(AddedEffect& added, const twin::EffectInfo& info, twin::ParameterRole role) {
  const auto index = twin::indexOf(info, role);
  if (!index) return nullptr;
  const auto found = std::ranges::find(added.values, info.parameters[*index].key, &AddedValue::key);
  return found == added.values.end() ? nullptr : &*found;
}

/// The links of a robot have a centre of mass each, and no common one.
void shiftIntoMass(AddedEffect& added, const twin::EffectInfo& info, const Case& given) {
  AddedValue* const shift = valueOf(added, info, twin::ParameterRole::kLoadShift);
  if (shift == nullptr || shift->value == 0) return;
  AddedValue* const mass = valueOf(added, info, twin::ParameterRole::kLoadMass);
  const twin::Parameter& parameter = info.parameters[*twin::indexOf(info, twin::ParameterRole::kLoadMass)];
  if (mass == nullptr)
    throw std::runtime_error(added.id + "." + shift->key + messages::kShiftNeedsMass + added.id + "." +
                             std::string{parameter.key} + "=0");
  const double factor = momentFactor(given, shift->value), wanted = (1 + mass->value) * factor - 1;
  const auto equal = [&](double value) { return forReading((1 + value) * factor - 1); };
  const twin::NumberRule rule = twin::ruleOf(parameter);
  added.because.push_back(mass->key + messages::kEqualMoment + withUnit(mass->value, parameter.unit) + ", " +
                          shift->key + " " + withUnit(shift->value, "m"));
  if (wanted < rule.low || wanted > rule.high)
    added.because.push_back(mass->key + ": " + withUnit(forReading(wanted), parameter.unit) + messages::kBeyondModel);
  *mass = {mass->key, std::clamp(equal(mass->value), rule.low, rule.high), equal(mass->low), equal(mass->high)};
  *shift = {shift->key, 0, std::nan(""), std::nan("")};
}

}  // namespace

Additions atJoint(Additions additions, const Case& given) {
  if (!given.joint) return additions;
  for (AddedNumber& number : additions.numbers) number.joint = given.joint;
  for (AddedEffect& effect : additions.effects) {
    const twin::EffectInfo* const info = twin::findEffect(effect.id);
    const bool is_load = info != nullptr && twin::indexOf(*info, twin::ParameterRole::kLoadMass).has_value();
    effect.joints = is_load ? outwardsOf(*given.joint) : std::vector{*given.joint};
    if (is_load) shiftIntoMass(effect, *info, given);
  }
  return additions;
}

}  // namespace darwinop::gap
