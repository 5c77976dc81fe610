// A hypothesis about a robot as a model of the twin: what was found, for `--robot twin:MODEL`.
#pragma once

#include <string>
#include <vector>

#include "gap/plant/body/floor_roll_out.hpp"
#include "gap/plant/body/moving_imu.hpp"

namespace darwinop::gap {

struct ModelWith {
  twin::Model model;
  std::vector<std::string> conflicts;  // sentences: what the model has already and cannot have twice
};

/// `base` as the hypothesis changes it: its servos, links, floor and sensors. The physics engine is not part of a
/// model. Throws std::runtime_error if the body's file is needed and cannot be read.
ModelWith modelWith(const twin::Model& base, const FloorHypothesis& hypothesis, const ImuDeviation& imu);

}  // namespace darwinop::gap
