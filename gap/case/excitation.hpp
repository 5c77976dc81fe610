// The excitation of the joint by one log.
#pragma once

#include "gap/case/data_check.hpp"

namespace darwinop::gap {

Excitation excitationOf(const Trajectory& log, const twin::ServoParameters& servo);

}  // namespace darwinop::gap
