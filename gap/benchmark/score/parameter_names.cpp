#include "gap/benchmark/score/parameter_names.hpp"

#include <algorithm>
#include <cmath>

#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

/// "friction_Nm": the key, and a unit.
bool isWithUnit(std::string_view name, std::string_view word) {
  return name == word || (name.starts_with(word) && name.substr(word.size()).starts_with('_'));
}

}  // namespace

std::optional<NamedParameter> parameterOf(std::string_view effect, std::string_view name) {
  const twin::EffectInfo* const info = twin::findEffect(effect);
  if (info == nullptr || name.empty()) return std::nullopt;
  if (name.starts_with(effect) && name.substr(effect.size()).starts_with('.')) name.remove_prefix(effect.size() + 1);
  for (const twin::OtherName& other : info->other_names)
    if (other.name == name) return NamedParameter{other.key, other.zero};
  // The longest key first: slow_motor before slow.
  const twin::Parameter* found = nullptr;
  for (const twin::Parameter& parameter : info->parameters)
    if (isWithUnit(name, parameter.key) && (found == nullptr || parameter.key.size() > found->key.size()))
      found = &parameter;
  if (found != nullptr) return NamedParameter{found->key};
  // "coulomb_Nm": the effect's own name stands for its first parameter.
  if (isWithUnit(name, effect)) return NamedParameter{info->parameters[0].key};
  return std::nullopt;
}

std::map<std::string, double> inCatalogueNames(std::string_view effect, const std::map<std::string, double>& values) {
  std::map<std::string, double> out;
  for (const auto& [name, value] : values)
    if (const auto parameter = parameterOf(effect, name)) out[std::string{parameter->key}] = value - parameter->zero;
  return out;
}

twin::ErrorScale errorScaleOf(std::string_view effect, std::string_view key) {
  if (const twin::EffectInfo* const info = twin::findEffect(effect))
    for (const twin::Parameter& parameter : info->parameters)
      if (parameter.key == key) return parameter.error_scale;
  return twin::ErrorScale::kRelative;
}

std::optional<double> relativeError(std::string_view effect, std::string_view key, double estimate, double truth) {
  const twin::ErrorScale compared = errorScaleOf(effect, key);
  if (compared == twin::ErrorScale::kNone) return std::nullopt;
  const double one = compared == twin::ErrorScale::kFromOne ? 1 : 0;
  if (truth == one) return std::nullopt;
  return std::abs((estimate - truth) / (truth - one));
}

}  // namespace darwinop::gap
