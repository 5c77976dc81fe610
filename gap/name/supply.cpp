#include "gap/name/supply.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gap/locate/cuts.hpp"

namespace darwinop::gap {
namespace {

constexpr double kWires = 0.5;     // ohm: between where the servo measures and where it draws
constexpr double kUnsure = 4;      // standard errors
constexpr double kMostUnsure = 1;  // ohm: the logs do not agree; nothing is said

}  // namespace

bool contradictsVoltage(const Case& given, const Settled& fitted) {
  const Hypothesis hypothesis = fitted.hypothesis();
  const twin::EffectSetting* const sag = hypothesis.find("supply_sag");
  if (sag == nullptr) return false;
  std::vector<double> slopes;
  for (const std::size_t log : fitted.evidence->logs)
    if (const double slope = supplyResistance(given, {&given.logs[log]}, baselineOf(given)); std::isfinite(slope))
      slopes.push_back(slope);
  if (slopes.size() < 3) return false;
  const auto count = static_cast<double>(slopes.size());
  double mean = 0, error = 0;
  for (const double slope : slopes) mean += slope / count;
  for (const double slope : slopes) error += std::pow(slope - mean, 2) / (count * (count - 1));
  error = std::sqrt(error);
  return error < kMostUnsure && sag->values[0] > std::max(0.0, mean) + std::max(kWires, kUnsure * error);
}

}  // namespace darwinop::gap
