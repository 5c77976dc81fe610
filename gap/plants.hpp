// The plant of a case. The one place that names the plants: all other code uses the interface.
#pragma once

#include "gap/plant/plant.hpp"

namespace darwinop::gap {

/// The plant that recorded the logs of a case. Every case is of a bench today.
const Plant& plantOf(const Case& given);

}  // namespace darwinop::gap
