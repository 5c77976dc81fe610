// What every stage of an investigation shares. Built once from a case, passed on by const reference.
#pragma once

#include "gap/fit/problem.hpp"
#include "gap/plant/plant.hpp"

namespace darwinop::gap {

struct Study {
  /// Simulates the fit logs with noise: seconds for ten logs. `given` must outlive the study.
  explicit Study(const Case& given, const NoiseOptions& noise = {});
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  const Case& data;
  const Plant& plant;
  const Hypothesis baseline;  // the model before anything is fitted or added
  const Evidence evidence;    // the logs to be fitted, with the noise that the baseline predicts for them
  const double gap_rad;       // rms position error of the baseline in closed loop, fit logs
};

}  // namespace darwinop::gap
