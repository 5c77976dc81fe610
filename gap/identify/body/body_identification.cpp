#include "gap/identify/body/body_identification.hpp"

#include <algorithm>
#include <chrono>

namespace darwinop::gap {
namespace {

Verdict verdictOf(const std::vector<SensorSelection>& sensors, const BodyTable& table) {
  const auto named = [](const SensorSelection& one) { return !one.found.effects.empty(); };
  if (std::ranges::any_of(sensors, [](const SensorSelection& one) { return !one.rivals.empty(); }))
    return Verdict::kAmbiguous;
  if (std::ranges::any_of(sensors, named)) return Verdict::kNamed;
  return table.open() > 0 ? Verdict::kUnknown : Verdict::kCannotTell;
}

}  // namespace

BodyIdentification identify(const BodyCase& given) {
  const auto begin = std::chrono::steady_clock::now();
  const RestingImu imu{given.joints.model};
  BodyIdentification out;
  out.table = localize(given, imu);
  out.sensors = identifySensors(given, imu, out.table);
  out.verdict = verdictOf(out.sensors, out.table);
  out.runtime_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace darwinop::gap
