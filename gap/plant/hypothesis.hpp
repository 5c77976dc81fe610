// A model of a bench: numbers of the servo, effects, pendulum, payload factor.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::gap {

struct Hypothesis {
  twin::ServoParameters servo;
  std::vector<twin::EffectSetting> effects;  // in the order of the catalogue, each at most once
  twin::Pendulum pendulum;                   // without the payload, which is each log's
  double payload_scale = 1;                  // of every log's payload

  /// Null: it does not have this effect.
  [[nodiscard]] twin::EffectSetting* find(std::string_view id);
  [[nodiscard]] const twin::EffectSetting* find(std::string_view id) const;
  /// The effect, added at its neutral values where it was not there.
  twin::EffectSetting& with(const twin::EffectInfo& info);
  void without(std::string_view id);

  /// Value of the parameter that has this role, of the first effect that has one; nothing if none has.
  [[nodiscard]] std::optional<double> value(twin::ParameterRole role) const;
  [[nodiscard]] bool has(twin::StepDemand demand) const;
  /// Control law, after an effect that replaces it.
  [[nodiscard]] twin::Law law() const;
};

/// The model that the case starts from.
Hypothesis baselineOf(const Case& given);

/// The case with another model as its baseline.
Case withModel(Case given, const Hypothesis& model);

/// Value of one parameter of an effect; the key is one of the effect's.
double& valueOf(twin::EffectSetting& setting, std::string_view key);

}  // namespace darwinop::gap
