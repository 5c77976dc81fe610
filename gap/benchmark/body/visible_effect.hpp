// Whether recordings show what is hidden in a robot: a case that nobody can solve says nothing about a method.
#pragma once

#include <cstddef>
#include <vector>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// How far a robot and the same one without something hidden are apart, in standard deviations of the noise: rms of
/// the worst half second of any joint's position or any axis of the inertial sensor. `again`: the robot recorded once
/// more; its noise has the chaos of walks and falls. `logs`: that all three have.
double worstDifference(const BodyCase& with, const BodyCase& without, const BodyCase& again,
                       const std::vector<std::size_t>& logs);

}  // namespace darwinop::gap
