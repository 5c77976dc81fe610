#include "gap/fit/unknown.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

void move(Hypothesis& hypothesis, const Unknown& unknown, double value) {
  std::visit(Cases{[&](LoadFactor factor) {
                     if (factor == LoadFactor::kPayload)
                       hypothesis.payload_scale *= value;
                     else if (factor == LoadFactor::kLength)
                       hypothesis.pendulum.length_m *= value;
                     else
                       hypothesis.pendulum.arm_mass_kg *= value;
                   },
                   [&](ServoFactor number) {
                     hypothesis.servo.*number *= value;
                     // One constant makes torque and back EMF.
                     if (number == &twin::ServoParameters::kt_nm_a) hypothesis.servo.back_emf_vs_rad *= value;
                   },
                   [&](WriteTime) { hypothesis.written_before_s = value; },
                   [&](const EffectParameter& parameter) {
                     hypothesis.with(*parameter.info, parameter.place).values[parameter.index] = value;
                   }},
             unknown.what);
}

Unknown factor(const BaselineNumber& known, double sigma) {
  Unknown unknown{.name = std::string{known.name}, .what = {}, .sigma = sigma};
  std::visit([&](auto what) { unknown.what = what; }, known.what);
  unknown.low = std::max(thresholds::kLeastPriorShare, 1 - thresholds::kFarthestPriorSigmas * sigma);
  unknown.high = 1 + thresholds::kFarthestPriorSigmas * sigma;
  return unknown;
}

bool isOfTheMotor(std::string_view name) {
  return name == "kt" || name == "back_emf" || name == "resistance" || name == "supply" || name == "duty_per_kp";
}

}  // namespace

double Unknown::toSearch(double value) const {
  return logarithmic ? std::log(std::max(value, low)) : value;
}

double Unknown::fromSearch(double x) const {
  return logarithmic ? std::exp(x) : x;
}

const EffectParameter* Unknown::parameterOf(const twin::EffectInfo& effect) const {
  const auto* const parameter = std::get_if<EffectParameter>(&what);
  return parameter != nullptr && parameter->info == &effect ? parameter : nullptr;
}

double Unknown::firstStep() const {
  if (logarithmic) return thresholds::kFirstLogStep;
  return std::isfinite(sigma) ? thresholds::kFirstStepSigmas * sigma : thresholds::kFirstStepShare * (high - low);
}

std::vector<Unknown> nuisancesOf(const Case& given, const Hypothesis& hypothesis) {
  std::vector<Unknown> unknowns;
  const bool motor = hypothesis.law() == twin::Law::kVoltageP, other_law = hypothesis.servo.law != twin::Law::kVoltageP;
  for (const BaselineNumber& known : kBaselineNumbers) {
    double sigma = 0;
    for (const Prior& prior : given.priors)
      if (prior.number == known.name) sigma = prior.relative_sigma;
    if (isOfTheMotor(known.name)) {
      if (!motor) continue;
      if (other_law)  // the numbers are the data sheet's
        sigma =
            given.datasheet && (known.name == "kt" || known.name == "resistance") ? given.datasheet->relative_sigma : 0;
    }
    if (sigma > 0) unknowns.push_back(factor(known, sigma));
  }
  if (const double longest_s = longestWriteTime(given); longest_s > 0)  // any time within a row is as likely
    unknowns.push_back({.name = WriteTime::kName,
                        .what = WriteTime{},
                        .expected = longest_s / 2,
                        .sigma = longest_s / std::sqrt(12.0),
                        .low = 0,
                        .high = longest_s});
  for (const Prior& prior : given.priors) {
    const std::size_t dot = prior.number.find('.');
    if (dot == std::string::npos) continue;
    const twin::EffectSetting* const effect = hypothesis.find(prior.number.substr(0, dot));
    if (effect == nullptr) continue;
    for (std::size_t i = 0; i < effect->values.size(); ++i) {
      if (effect->info->parameters[i].key != prior.number.substr(dot + 1) || effect->values[i] == 0) continue;
      const double value = effect->values[i], sigma = std::abs(value) * prior.relative_sigma;
      unknowns.push_back(
          {.name = prior.number,
           .what = EffectParameter{effect->info, i, {}},
           .expected = value,
           .sigma = sigma,
           .low = std::max(thresholds::kLeastPriorShare * value, value - thresholds::kFarthestPriorSigmas * sigma),
           .high = value + thresholds::kFarthestPriorSigmas * sigma});
    }
  }
  return unknowns;
}

std::vector<Unknown> unknownsOf(const twin::EffectInfo& info, bool refined, const Place& place) {
  std::vector<Unknown> unknowns;
  const std::string prefix = place.name.empty() ? "" : place.name + ".";
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const twin::Parameter& parameter = info.parameters[i];
    if (parameter.fixed || (parameter.secondary && !refined)) continue;
    Unknown unknown{.name = prefix + std::string{info.id} + "." + std::string{parameter.key},
                    .what = EffectParameter{&info, i, place},
                    .expected = parameter.typical,
                    .low = parameter.low,
                    .high = parameter.high,
                    .logarithmic = parameter.logarithmic};
    if (unknown.logarithmic && unknown.low <= 0) unknown.low = thresholds::kSmallestScale * unknown.high;
    if (unknown.logarithmic && unknown.expected <= unknown.low)
      unknown.expected = std::sqrt(unknown.low * unknown.high);
    unknowns.push_back(std::move(unknown));
  }
  return unknowns;
}

Hypothesis applied(Hypothesis hypothesis, const std::vector<Unknown>& unknowns, const double* x) {
  for (std::size_t i = 0; i < unknowns.size(); ++i) move(hypothesis, unknowns[i], unknowns[i].fromSearch(x[i]));
  return hypothesis;
}

}  // namespace darwinop::gap
