#include "gap/locate/where.hpp"

#include <cmath>

namespace darwinop::gap {

double Where::rms_rad() const {
  double sum = 0, count = 0;
  for (const LogResidual& one : residuals)
    sum += one.position_rad.squaredNorm(), count += static_cast<double>(one.position_rad.size());
  return std::sqrt(sum / count);
}

double Where::floors() const {
  double sum = 0, count = 0;
  for (const LogFloor& one : floor.logs)
    sum += one.sigma_rad.squaredNorm(), count += static_cast<double>(one.sigma_rad.size());
  return rms_rad() / std::sqrt(sum / count);
}

Where locate(const Case& given, const Evidence& evidence) {
  Where where;
  for (const std::size_t log : evidence.logs) where.files.push_back(given.logs[log].file);
  const Copies copies = copiesOf(given, evidence.logs, baselineOf(given));
  where.floor = floorOf(given, evidence, copies);
  where.residuals = residualsOf(given, evidence, where.floor);
  where.blocks = findBlocks(given, evidence.logs, copies);
  where.places = placesOf(given, where.residuals, where.blocks);
  if (!where.blocks.first && where.places.empty()) return where;  // noise depends on nothing
  where.dependence = dependenceOf(given, where.residuals, where.blocks);
  return where;
}

}  // namespace darwinop::gap
