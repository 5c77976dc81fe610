#include "gap/plant/hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "gap/plant/write_instant.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

// Effects act in this order.
auto placeInCatalogue(const twin::EffectInfo* info) {
  const auto all = twin::catalogue();
  return std::find(all.begin(), all.end(), info) - all.begin();
}

/// An arm without mass has no scale.
double armMassScale(const Case& given, const Hypothesis& hypothesis) {
  return given.pendulum.arm_mass_kg > 0 ? hypothesis.pendulum.arm_mass_kg / given.pendulum.arm_mass_kg : 1;
}

}  // namespace

const twin::EffectSetting* Hypothesis::find(std::string_view id, const Place& place) const {
  const auto found = std::ranges::find_if(effects, [&](const auto& e) { return e.info->id == id && e.place == place; });
  return found == effects.end() ? nullptr : &*found;
}

twin::EffectSetting* Hypothesis::find(std::string_view id, const Place& place) {
  return const_cast<twin::EffectSetting*>(std::as_const(*this).find(id, place));
}

twin::EffectSetting& Hypothesis::with(const twin::EffectInfo& info, const Place& place) {
  if (twin::EffectSetting* const there = find(info.id, place)) return *there;
  PlacedEffect setting{{.info = &info, .values = {}, .joint = {}}, place};
  for (const twin::Parameter& parameter : info.parameters) setting.values.push_back(parameter.neutral);
  const auto before = std::find_if(effects.begin(), effects.end(), [&](const auto& other) {
    return placeInCatalogue(other.info) > placeInCatalogue(&info);
  });
  return *effects.insert(before, std::move(setting));
}

void Hypothesis::without(std::string_view id, const Place& place) {
  std::erase_if(effects, [&](const auto& effect) { return effect.info->id == id && effect.place == place; });
}

std::optional<double> Hypothesis::value(twin::ParameterRole role) const {
  for (const twin::EffectSetting& effect : effects)
    if (const auto index = twin::indexOf(*effect.info, role)) return effect.values[*index];
  return std::nullopt;
}

bool Hypothesis::has(twin::StepDemand demand) const {
  return std::ranges::any_of(effects, [&](const auto& effect) { return effect.info->step_demand == demand; });
}

twin::Law Hypothesis::law() const {
  const bool replaced = std::ranges::any_of(
      effects, [](const twin::EffectSetting& effect) { return twin::replacesLaw(*effect.info, effect.values); });
  return replaced ? twin::Law::kVoltageP : servo.law;
}

bool loadIsDuty(const Hypothesis& hypothesis) {
  return hypothesis.servo.law == twin::Law::kVoltageP;
}

bool loadIsDutyIn(const Hypothesis& hypothesis, const Trajectory& log) {
  return loadIsDuty(hypothesis) && std::ranges::any_of(log.load, [](double load) { return !std::isnan(load); });
}

Hypothesis baselineOf(const Case& given) {
  Hypothesis baseline{.servo = given.model.servo, .effects = {}, .pendulum = given.pendulum, .payload_scale = 1};
  for (const twin::EffectSetting& effect : given.model.effects) baseline.with(*effect.info).values = effect.values;
  if (given.written_before_s)
    baseline.written_before_s = *given.written_before_s;
  else if (const double longest_s = longestWriteTime(given); longest_s > 0)
    baseline.written_before_s = longest_s / 2;
  return baseline;
}

twin::Pendulum armOf(const Case& given, const Trajectory& log, const Hypothesis& hypothesis) {
  twin::Pendulum arm = hypothesis.pendulum;
  arm.payload_kg = log.payload_kg * hypothesis.payload_scale;
  if (log.length_m) arm.length_m *= *log.length_m / given.pendulum.length_m;
  if (log.arm_mass_kg) arm.arm_mass_kg = *log.arm_mass_kg * armMassScale(given, hypothesis);
  return arm;
}

double supplyOf(const Case& given, const Trajectory& log, const Hypothesis& hypothesis) {
  const double scale = log.supply_v ? *log.supply_v / given.model.servo.supply_v : 1;
  return hypothesis.servo.supply_v * scale;
}

Case withModel(Case given, const Hypothesis& model) {
  for (Trajectory& log : given.logs) {
    if (log.arm_mass_kg) *log.arm_mass_kg *= armMassScale(given, model);
    if (log.length_m) *log.length_m *= model.pendulum.length_m / given.pendulum.length_m;
    if (log.supply_v) *log.supply_v *= model.servo.supply_v / given.model.servo.supply_v;
  }
  given.model.servo = model.servo;
  given.model.effects.assign(model.effects.begin(), model.effects.end());
  given.pendulum = model.pendulum;
  if (std::isfinite(model.written_before_s)) given.written_before_s = model.written_before_s;
  for (Trajectory& log : given.logs) log.payload_kg *= model.payload_scale;
  return given;
}

double& valueOf(twin::EffectSetting& setting, std::string_view key) {
  const auto& parameters = setting.info->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].key == key) return setting.values[i];
  throw std::logic_error("effect " + std::string{setting.info->id} + " has no parameter " + std::string{key});
}

}  // namespace darwinop::gap
