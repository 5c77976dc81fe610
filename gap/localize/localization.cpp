#include "gap/localize/localization.hpp"

#include <cmath>

namespace darwinop::gap {

double Localization::rms_rad() const {
  double sum = 0, count = 0;
  for (const LogResidual& one : residuals) sum += one.squareSum(), count += one.known();
  return std::sqrt(sum / count);
}

double Localization::floors() const {
  RmsSum sum;
  for (const LogFloor& one : floor.logs) sum.add(one.positions);
  return rms_rad() / sum.rms();
}

Localization localize(const Study& study) {
  const Case& data = study.data;
  const std::vector<std::size_t>& logs = study.evidence.logs;
  Localization where;
  for (const std::size_t log : logs) where.files.push_back(data.logs[log].file);
  const SimulatedRepeats repeats = simulateRepeats(study.plant, data, logs, study.baseline);
  where.floor = floorOf(data, study.evidence, repeats);
  where.residuals = residualsOf(study, where.floor);
  where.blocks = findBlocks(study.plant, data, study.baseline, logs, repeats);
  where.places = intervalsOf(data, where.residuals, where.blocks);
  const bool is_noise = !where.blocks.first && where.places.empty();
  if (!is_noise) where.dependence = dependenceOf(data, where.residuals, where.blocks);
  return where;
}

}  // namespace darwinop::gap
