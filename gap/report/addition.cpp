// Effects and numbers into the text of a model file.
#include "gap/report/addition.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text/nearest.hpp"
#include "gap/report/joint_numbers.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/law_check.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::gap {
namespace {

const twin::EffectInfo& effectCalled(const std::string& id) {
  if (const twin::EffectInfo* const info = twin::findEffect(id)) return *info;
  throw std::runtime_error("there is no effect '" + id + "'; " + text::suggestion(id, twin::effectIds()) +
                           " (docs/twin/effects.md)");
}

std::size_t parameterCalled(const twin::EffectInfo& info, const std::string& key) {
  const auto found = std::ranges::find(info.parameters, key, &twin::Parameter::key);
  if (found == info.parameters.end())
    throw std::runtime_error("effect " + std::string{info.id} + " has no parameter '" + key + "'; " +
                             text::suggestion(key, twin::parametersOf(info)));
  return static_cast<std::size_t>(found - info.parameters.begin());
}

void checkRange(const twin::EffectInfo& info, const twin::Parameter& parameter, double value) {
  const twin::NumberRule rule = twin::ruleOf(parameter);
  if (std::isfinite(value) && value >= rule.low && value <= rule.high) return;
  throw std::runtime_error(std::string{info.id} + "." + std::string{parameter.key} + " = " +
                           withUnit(value, parameter.unit) + " is none that a servo has; give " + twin::allowed(rule));
}

std::string withEffectNumber(const std::string& text, const AddedNumber& number) {
  const std::size_t dot = number.key.find('.');
  const twin::EffectInfo& info = effectCalled(number.key.substr(0, dot));
  const std::size_t i = parameterCalled(info, number.key.substr(dot + 1));
  const twin::Model model = twin::parseModel(text, "the model");
  std::vector<twin::EffectSetting> effects = servoEffects(model, number.joint);
  const auto there = std::ranges::find(effects, &info, &twin::EffectSetting::info);
  if (there == effects.end())
    throw std::runtime_error("the model has no [effect " + std::string{info.id} + "], so no number can be changed");
  checkRange(info, info.parameters[i], number.value);
  const std::string was = withUnit(there->values[i], info.parameters[i].unit);
  there->values[i] = number.value;
  there->joint = number.joint;
  return twin::withEffect(text, *there, {"Moved by the fit, within how far it may be trusted; was " + was});
}

/// At `joint`; what is not given stays as `model` has it.
twin::EffectSetting settingOf(const AddedEffect& added, std::optional<Joint> joint, const twin::Model& model,
                              std::vector<std::string>& comments) {
  const twin::EffectInfo& info = effectCalled(added.id);
  twin::EffectSetting setting{.info = &info, .values = {}, .joint = joint};
  for (const twin::Parameter& parameter : info.parameters) setting.values.push_back(parameter.typical);
  const std::vector<twin::EffectSetting> effects = servoEffects(model, joint);
  const auto there = std::ranges::find(effects, &info, &twin::EffectSetting::info);
  if (there != effects.end()) setting.values = there->values;
  std::vector<bool> given(info.parameters.size(), false);
  for (const AddedValue& value : added.values) {
    const std::size_t i = parameterCalled(info, value.key);
    checkRange(info, info.parameters[i], value.value);
    setting.values[i] = value.value;
    given[i] = true;
    if (std::isfinite(value.low) && std::isfinite(value.high))
      comments.push_back(value.key + ": 90 % interval " + interval(value.low, value.high, info.parameters[i].unit));
  }
  if (std::ranges::find(given, true) == given.end())
    throw std::runtime_error("effect " + added.id + " has no value; give one, " + added.id + "." +
                             std::string{info.parameters.front().key} + "=VALUE");
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!given[i] && there == effects.end())
      comments.push_back(std::string{info.parameters[i].key} + ": " + messages::kTypicalValue);
  return setting;
}

}  // namespace

Additions additionsFrom(const std::vector<std::string>& texts) {
  Additions additions;
  for (const std::string& text : texts) {
    const std::size_t dot = text.find('.'), equals = text.find('=');
    const std::string wanted = "'" + text + "' is not an effect; write ID.PARAMETER=VALUE, as in coulomb.friction=0.05";
    if (dot == std::string::npos || equals == std::string::npos || dot > equals) throw std::runtime_error(wanted);
    const std::string id = text.substr(0, dot), key = text.substr(dot + 1, equals - dot - 1);
    double value = 0;
    try {
      std::size_t used = 0;
      value = std::stod(text.substr(equals + 1), &used);
      if (equals + 1 + used != text.size()) throw std::invalid_argument(text);
    } catch (const std::logic_error&) {
      throw std::runtime_error(wanted + "; " + messages::kUnitNotAllowed + ", in the unit of docs/twin/effects.md");
    }
    auto effect = std::ranges::find(additions.effects, id, &AddedEffect::id);
    if (effect == additions.effects.end())
      effect = additions.effects.insert(effect, {id, {}, {"Put in by hand: darwinop gap add"}});
    if (std::ranges::find(effect->values, key, &AddedValue::key) != effect->values.end())
      throw std::runtime_error("'" + text + "': " + messages::kNumberGivenTwice + "; keep one of the two");
    effect->values.push_back({key, value, std::nan(""), std::nan("")});
  }
  return additions;
}

std::string withAdditions(std::string text, const Additions& given) {
  Additions additions = withJointNumbers(given, twin::parseModel(text, "the model"));
  // An effect that needs another law comes after the one that brings it.
  std::stable_partition(additions.effects.begin(), additions.effects.end(), [](const AddedEffect& added) {
    return effectCalled(added.id).laws == twin::Laws::kReplacesSpeedP;
  });
  for (const AddedNumber& number : additions.numbers)
    text = number.key.find('.') == std::string::npos ? withNumber(text, number.section, number.key, number.value)
                                                     : withEffectNumber(text, number);
  for (const AddedEffect& added : additions.effects) {
    const twin::Model model = twin::parseModel(text, "the model");
    std::vector<std::optional<Joint>> places(added.joints.begin(), added.joints.end());
    if (places.empty()) {
      places.emplace_back();
      for (const twin::EffectSetting& there : model.effects)
        if (there.info->id == added.id && there.joint) places.push_back(there.joint);
    }
    for (const std::optional<Joint>& joint : places) {
      std::vector<std::string> comments = added.because;
      const twin::EffectSetting setting = settingOf(added, joint, model, comments);
      if (const twin::Parameter* const idle = twin::withoutEquation(model, setting))
        throw std::runtime_error(added.id + "." + std::string{idle->key} + twin::lawAdvice(*setting.info, *idle));
      text = twin::withEffect(text, setting, wrapped(comments));
    }
  }
  for (const AddedAxes& axes : additions.axes) text = withAxes(text, axes.section, axes.key, axes.values);
  return text;
}

}  // namespace darwinop::gap
