#include "gap/study.hpp"

#include "gap/plants.hpp"

namespace darwinop::gap {

Study::Study(const Case& given, const NoiseOptions& noise)
    : data{given},
      plant{plantOf(given)},
      baseline{baselineOf(given)},
      evidence{evidenceOf(plant, given, baseline, LogRole::kFit, noise)},
      gap_rad{rmsPositionError(plant, given, baseline, LogRole::kFit)} {}

}  // namespace darwinop::gap
