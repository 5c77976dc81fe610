// Below what nothing is a gap: what two runs of the same thing differ by, log by log.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/fit/problem.hpp"
#include "gap/localize/simulated_repeats.hpp"

namespace darwinop::gap {

/// Of the positions of one log, rad.
struct LogFloor {
  std::size_t log = 0;          // index in the case
  double quantisation_rad = 0;  // rounding and noise of the encoder
  double repeats_rad = 0;       // rms of the difference of two measured runs over root 2; NaN: nobody repeated it
  double expected_rad = 0;      // the same of simulated runs; NaN with the former
  double rms_rad = 0;           // of sigma_rad
  Eigen::VectorXd sigma_rad;    // a sample each: encoder, and what the assumed disturbance does to this motion
};

struct NoiseFloor {
  std::vector<LogFloor> logs;  // of the evidence
  bool assumed = true;         // no log was repeated: the disturbance is an assumption
  // Measured repeats over simulated ones. Far from 1: the noise is another one, or something changed between the runs
  // (a servo that warmed up). It does not widen the floor: what changes with the clock is a gap as well.
  double factor = 1;
};

NoiseFloor floorOf(const Case& given, const Evidence& evidence, const SimulatedRepeats& copies);

}  // namespace darwinop::gap
