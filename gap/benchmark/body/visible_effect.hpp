// Visibility of a hidden effect in recordings: an effect below the noise floor cannot be identified by any method.
#pragma once

#include <cstddef>
#include <vector>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// Largest rms difference, within half a second, between recordings with and without an effect, over all joint
/// positions and axes of the inertial sensor, in standard deviations of the noise. `again`: a repeat of `with`, which
/// gives the noise of each signal and log, including the divergence of walks. `logs`: indices of logs that all three
/// have. Missing readings count as no difference; a signal without readings is left out.
double worstDifference(const BodyCase& with, const BodyCase& without, const BodyCase& again,
                       const std::vector<std::size_t>& logs);

}  // namespace darwinop::gap
