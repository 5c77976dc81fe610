// Selection of effects of each inertial sensor: every set of one or two, by its evidence.
#include <algorithm>
#include <cmath>

#include "gap/identify/body/body_identification.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// None, one or two effects. A map and a rotation together are a rotation that the priors exclude.
std::vector<std::vector<const SensorEffect*>> setsOf(ImuSensor sensor) {
  std::vector<const SensorEffect*> single;
  for (const SensorEffect& effect : sensorEffects())
    if (effect.sensor == sensor) single.push_back(&effect);
  std::vector<std::vector<const SensorEffect*>> sets{{}};
  const auto turns = [](const SensorEffect* effect) {
    return effect->number == SensorEffect::Number::kMap || effect->number == SensorEffect::Number::kRotation;
  };
  for (std::size_t i = 0; i < single.size(); ++i) {
    sets.push_back({single[i]});
    for (std::size_t j = i + 1; j < single.size(); ++j)
      if (!turns(single[i]) || !turns(single[j])) sets.push_back({single[i], single[j]});
  }
  return sets;
}

bool isClose(const SensorFit& rival, const SensorFit& best) {
  const bool is_larger = rival.effects.size() > best.effects.size();
  return best.evidence - rival.evidence < (is_larger ? thresholds::kLargerRivalEvidence : thresholds::kRivalEvidence);
}

/// `fits`: best first. An effect more has to earn its place: the smallest set that the data do not exclude.
std::size_t selected(const std::vector<SensorFit>& fits) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < fits.size(); ++i)
    if (isClose(fits[i], fits.front()) && fits[found].extends(fits[i])) found = i;
  return found;
}

/// Held-out logs are less likely with these effects than without, by more than the errors of their numbers explain.
bool isRefuted(const SensorFit& fit, const RestingProblem& held_out) {
  if (held_out.readings() == 0 || fit.effects.empty()) return false;
  return held_out.misfitOf(fit) - held_out.misfitOf(SensorFit{}) > static_cast<double>(fit.values.size());
}

}  // namespace

std::vector<SensorSelection> identifySensors(const BodyCase& given, const RestingImu& imu, const BodyTable& table) {
  std::vector<SensorSelection> out;
  for (const ImuSensor sensor : kImuSensors) {
    const RestingProblem problem{given, imu, sensor};
    if (problem.readings() == 0) continue;
    std::vector<SensorFit> fits;
    for (auto& set : setsOf(sensor)) fits.push_back(problem.fit(std::move(set)));
    std::ranges::stable_sort(fits, std::greater{}, &SensorFit::evidence);
    const RestingProblem held_out{given, imu, sensor, true};
    std::size_t found = selected(fits);
    for (; isRefuted(fits[found], held_out); found = selected(fits))
      fits.erase(fits.begin() + static_cast<std::ptrdiff_t>(found));
    SensorSelection one{.sensor = sensor, .found = fits[found], .rivals = {}};
    for (std::size_t i = 0; i < fits.size(); ++i)
      if (i != found && isClose(fits[i], fits[found]) && !fits[i].extends(fits[found])) one.rivals.push_back(fits[i]);
    const auto count = static_cast<double>(problem.readings());
    one.remains = sigmasOfChiSquared(one.found.chi2, count) > table.open_from;
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace darwinop::gap
