#include "gap/study.hpp"

#include "gap/plant/bench/position_error.hpp"

namespace darwinop::gap {

Study::Study(const Case& given, const NoiseOptions& noise)
    : data{given},
      plant{plantOf(given)},
      baseline{baselineOf(given)},
      evidence{evidenceOf(given, baseline, LogRole::kFit, noise)},
      gap_rad{rmsPositionError(given, baseline, LogRole::kFit)} {}

}  // namespace darwinop::gap
