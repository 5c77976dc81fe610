// A model of a bench: numbers of the servo, effects, pendulum, payload factor.
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"
#include "gap/plant/place.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::gap {

struct PlacedEffect : twin::EffectSetting {
  Place place;
};

/// An effect is found by its id and its place; without a place: that of a bench.
struct Hypothesis {
  twin::ServoParameters servo;
  std::vector<PlacedEffect> effects;  // in the order of the catalogue, each at most once a place
  twin::Pendulum pendulum;            // without the payload, which is each log's
  double payload_scale = 1;           // of every log's payload
  /// From the write of a goal to the read of its row, s; for GoalOrder::kBeforeRead. Infinity: right after the read of
  /// the row before.
  double written_before_s = std::numeric_limits<double>::infinity();

  /// Null: it does not have this effect.
  [[nodiscard]] twin::EffectSetting* find(std::string_view id, const Place& place = {});
  [[nodiscard]] const twin::EffectSetting* find(std::string_view id, const Place& place = {}) const;
  /// The effect, added at its neutral values where it was not there.
  twin::EffectSetting& with(const twin::EffectInfo& info, const Place& place = {});
  void without(std::string_view id, const Place& place = {});

  /// Value of the parameter that has this role, of the first effect that has one; nothing if none has.
  [[nodiscard]] std::optional<double> value(twin::ParameterRole role) const;
  [[nodiscard]] bool has(twin::StepDemand demand) const;
  /// Control law, after an effect that replaces it.
  [[nodiscard]] twin::Law law() const;
};

/// True: the load register holds the duty of the bridge (law voltage_p).
bool loadIsDuty(const Hypothesis& hypothesis);
/// The same, and the log has the column.
bool loadIsDutyIn(const Hypothesis& hypothesis, const Trajectory& log);

/// The model that the case starts from.
Hypothesis baselineOf(const Case& given);

/// Arm of a log's bench under the hypothesis, with its payload. Where a log has an arm of its own, the hypothesis
/// scales its length and mass as it does those of the case.
twin::Pendulum armOf(const Case& given, const Trajectory& log, const Hypothesis& hypothesis);
/// Nominal supply of a log's bench under the hypothesis, V; scaled in the same way.
double supplyOf(const Case& given, const Trajectory& log, const Hypothesis& hypothesis);

/// The case with another model as its baseline.
Case withModel(Case given, const Hypothesis& model);

/// Value of one parameter of an effect; the key is one of the effect's.
double& valueOf(twin::EffectSetting& setting, std::string_view key);

}  // namespace darwinop::gap
