#include "gap/report/joint_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <variant>

#include "core/text/number_text.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

constexpr double kSameRatio = 1e-4;  // of numbers with six digits

struct ServoAlias {
  const twin::EffectInfo* info;
  const twin::BaselineAlias* alias;
};

std::optional<ServoAlias> aliasFor(const std::string& number) {
  for (const twin::EffectInfo* const info : twin::catalogue())
    for (const twin::BaselineAlias& alias : info->aliases)
      if (alias.number == number && alias.relation != twin::BaselineAlias::Relation::kOwnValue)
        return ServoAlias{info, &alias};
  return std::nullopt;
}

bool isOfJoint(const AddedNumber& number) {
  return number.joint && number.section == "servo" && number.key.find('.') == std::string::npos;
}

/// The number of [servo] that `model` has.
double before(const AddedNumber& number, twin::Model model) {
  const twin::KeyRow* const row = twin::findKey(number.section, number.key);
  const twin::Slot slot = row == nullptr ? twin::Slot{} : row->in(model);
  const double* const* const value = std::get_if<double*>(&slot);
  return value == nullptr || *value == nullptr ? std::numeric_limits<double>::quiet_NaN() : **value;
}

/// All values of the effect at a joint of `model`; neutral where it has none.
AddedEffect presentAt(Joint joint, const twin::EffectInfo& info, const twin::Model& model) {
  AddedEffect out{std::string{info.id}, {}, {}, {joint}};
  const std::vector<twin::EffectSetting> effects = servoEffects(model, joint);
  const auto there = std::ranges::find(effects, &info, &twin::EffectSetting::info);
  for (std::size_t i = 0; i < info.parameters.size(); ++i)
    out.values.push_back({std::string{info.parameters[i].key},
                          there == effects.end() ? info.parameters[i].neutral : there->values[i], std::nan(""),
                          std::nan("")});
  return out;
}

class JointNumbers {
 public:
  JointNumbers(Additions additions, const twin::Model& model) : out_{std::move(additions)}, model_{model} {}

  Additions run() {
    const std::vector<AddedNumber> numbers = out_.numbers;
    for (const AddedNumber& number : numbers)
      if (isOfJoint(number)) convert(number, numbers);
    return std::move(out_);
  }

 private:
  void convert(const AddedNumber& number, const std::vector<AddedNumber>& numbers) {
    const auto found = aliasFor(number.key);
    if (!found) return;
    const twin::EffectInfo* const info = found->info;
    const twin::BaselineAlias* const alias = found->alias;
    const double was = before(number, model_);
    const auto other = std::ranges::find(numbers, alias->with, &AddedNumber::key);
    if (!alias->with.empty() &&
        (other == numbers.end() ||
         !(std::abs(other->value / before(*other, model_) * was / number.value - 1) < kSameRatio)))
      return;
    auto effect = std::ranges::find(out_.effects, info->id, &AddedEffect::id);
    AddedEffect changed = effect == out_.effects.end() ? presentAt(*number.joint, *info, model_) : *effect;
    const twin::Parameter& parameter = info->parameters[alias->parameter];
    const auto value = std::ranges::find(changed.values, parameter.key, &AddedValue::key);
    if (value == changed.values.end()) return;
    const double exact = alias->valueBetween(was, alias->together(number.value, value->value));
    const double now = std::strtod(text::generalText(exact, 6).c_str(), nullptr);  // more than a fit determines
    const twin::NumberRule rule = twin::ruleOf(parameter);
    if (!(now >= rule.low && now <= rule.high)) return;
    *value = {value->key, now, std::nan(""), std::nan("")};  // the interval was that of the effect alone
    const std::string unit{twin::findKey(number.section, number.key)->number.unit};
    changed.because.push_back("[servo] " + number.key + messages::kTogether +
                              withUnit(alias->together(was, now), unit));
    if (effect == out_.effects.end())
      out_.effects.push_back(std::move(changed));
    else
      *effect = std::move(changed);
    std::erase_if(out_.numbers, [&](const AddedNumber& one) {
      return isOfJoint(one) && (one.key == number.key || one.key == alias->with);
    });
  }

  Additions out_;
  const twin::Model& model_;
};

}  // namespace

Additions withJointNumbers(Additions additions, const twin::Model& model) {
  return JointNumbers{std::move(additions), model}.run();
}

}  // namespace darwinop::gap
