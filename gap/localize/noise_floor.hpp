// Noise floor: run-to-run difference of repeated logs.
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
  double repeats_rad = 0;       // standard deviation of the measured runs of this motion; NaN: not repeated
  double expected_rad = 0;      // the same of simulated runs; NaN with the former
  bool bifurcates = false;      // measured repeats come to rest in different places
  double rms_rad = 0;           // of `positions`
  RmsSum positions;             // standard deviation of each: encoder, and the assumed disturbance on this motion
};

struct NoiseFloor {
  std::vector<LogFloor> logs;  // of the evidence
  bool assumed = true;         // no fitted log was repeated: the disturbance is an assumption
  double repeats_rad = 0;      // standard deviation over all repeats of the case, held-out ones included; NaN: none
  // Measured over simulated spread of the fitted repeats. Far from 1: other noise than assumed, or a change between the
  // runs such as a servo that warmed up. It does not widen the floor: a change over time is a gap as well.
  double factor = 1;
};

NoiseFloor floorOf(const Case& given, const Evidence& evidence, const SimulatedRepeats& copies);

}  // namespace darwinop::gap
