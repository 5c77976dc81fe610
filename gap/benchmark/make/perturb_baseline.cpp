#include "gap/benchmark/make/perturb_baseline.hpp"

#include <algorithm>

#include "gap/case/baseline_keys.hpp"

namespace darwinop::gap {
namespace {

void scale(const std::string& number, double factor, Hypothesis& bench) {
  if (number == "payload") bench.payload_scale *= factor;
  if (number == "length") bench.pendulum.length_m *= factor;
  if (number == "arm_mass") bench.pendulum.arm_mass_kg *= factor;
  if (number == "kt") bench.servo.back_emf_vs_rad *= factor;
  if (number == "back_emf") bench.servo.back_emf_vs_rad *= factor;
  for (const ServoKey& key : servoKeys())
    if (key.key == number) bench.servo.*key.member *= factor;
  const std::size_t dot = number.find('.');
  if (dot == std::string::npos) return;
  if (twin::EffectSetting* const effect = bench.find(number.substr(0, dot)))
    valueOf(*effect, number.substr(dot + 1)) *= factor;
}

}  // namespace

std::map<std::string, double> makeWrong(const Case& given, Rng& rng, Hypothesis& bench) {
  std::vector<Prior> priors = given.priors;
  // A motor that the baseline does not have is not quite its data sheet's either.
  if (given.model.servo.law == twin::Law::kSpeedP && given.datasheet)
    for (const char* number : {"kt", "resistance"}) priors.push_back({number, given.datasheet->relative_sigma / 2});
  std::map<std::string, double> factors;
  for (const Prior& prior : priors) {
    const double factor = 1 + std::clamp(rng.normal(), -1.0, 1.0) * prior.relative_sigma;
    scale(prior.number, factor, bench);
    factors[prior.number] = factor;
  }
  return factors;
}

}  // namespace darwinop::gap
