// On which side a robot lies.
#pragma once

#include <cstddef>
#include <string_view>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// "left" or "right": the side that is down in the first half second of this log; empty: nothing shows it. A clamped
/// log with a side down shows what the sensor reads there; without one its axes and scale are those of the model.
std::string_view sideOf(const BodyCase& given, std::size_t log);

}  // namespace darwinop::gap
