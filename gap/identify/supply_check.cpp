#include "gap/identify/supply_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
bool contradictsVoltage(const FittedModel& fitted) {
  const Study& study = *fitted.study;
  const Hypothesis hypothesis = fitted.hypothesis();
  const std::optional<double> resistance_ohm = hypothesis.value(twin::ParameterRole::kSupplyResistance);
  if (!resistance_ohm) return false;
  std::vector<double> slopes;
  for (const std::size_t log : fitted.evidence->logs)
    if (const double slope = study.plant.supplyResistance(study.plant.places().front(), study.data,
                                                          {&study.data.logs[log]}, study.baseline);
        std::isfinite(slope))
      slopes.push_back(slope);
  if (slopes.size() < 3) return false;
  const auto count = static_cast<double>(slopes.size());
  double mean = 0, error = 0;
  for (const double slope : slopes) mean += slope / count;
  for (const double slope : slopes) error += std::pow(slope - mean, 2) / (count * (count - 1));
  error = std::sqrt(error);
  return error<thresholds::kSupplyUncertainOhm&& * resistance_ohm> std::max(0.0, mean) +
         std::max(thresholds::kWiringOhm, thresholds::kSupplyErrors * error);
}

}  // namespace darwinop::gap
