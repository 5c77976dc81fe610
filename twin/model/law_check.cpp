#include "twin/model/law_check.hpp"

#include <algorithm>
#include <ranges>

#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/messages.hpp"

namespace darwinop::twin {
namespace {

Law lawAt(const Model& model, Joint joint) {
  const bool replaced = std::ranges::any_of(catalogue(), [&](const EffectInfo* info) {
    const EffectSetting* const setting = settingAt(model, *info, joint);
    return setting != nullptr && replacesLaw(*info, setting->values);
  });
  return replaced ? Law::kVoltageP : model.servo.law;
}

/// Joints at which this setting, or one like it that the model does not have yet, would act.
bool actsAt(const Model& model, const EffectSetting& setting, Joint joint) {
  if (setting.joint) return *setting.joint == joint;
  const EffectSetting* const there = settingAt(model, *setting.info, joint);
  return there == nullptr || !there->joint;
}

}  // namespace

const EffectSetting* settingAt(const Model& model, const EffectInfo& effect, Joint joint) {
  const EffectSetting* chosen = nullptr;
  for (const EffectSetting& setting : model.effects)
    if (setting.info == &effect && (setting.joint == joint || (!setting.joint && chosen == nullptr))) chosen = &setting;
  return chosen;
}

const Parameter* withoutEquation(const Model& model, const EffectSetting& setting) {
  bool acts_anywhere = false, acts_by_voltage = false;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    if (!actsAt(model, setting, joint)) continue;
    acts_anywhere = true;
    acts_by_voltage = acts_by_voltage || lawAt(model, joint) == Law::kVoltageP;
  }
  if (!acts_anywhere || acts_by_voltage) return nullptr;
  for (std::size_t i = 0; i < setting.values.size(); ++i) {
    const Parameter& parameter = setting.info->parameters[i];
    if (lawsOf(*setting.info, parameter) == Laws::kVoltageP && setting.values[i] != parameter.neutral)
      return &parameter;
  }
  return nullptr;
}

std::string lawAdvice(const EffectInfo& effect, const Parameter& parameter) {
  return std::string{messages::kNoEquation} +
         (effect.laws == Laws::kVoltageP
              ? "remove the section"
              : "give " + std::string{parameter.key} + " = " + writeNumber(parameter.neutral, ruleOf(parameter))) +
         ", or choose the law voltage_p in [servo]";
}

}  // namespace darwinop::twin
