// On which side a robot lies.
#pragma once

#include <string_view>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// "left" or "right": the side that is down, by the accelerometer's mean over the first half second; empty: it does not
/// show it. Axes and scale of the sensor are those of the model.
std::string_view sideOf(const BodyLog& log, const twin::ImuSettings& imu);

}  // namespace darwinop::gap
