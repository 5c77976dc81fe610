// Numbers of [servo] that were found for the servo of one joint, as effects of that joint.
#pragma once

#include "gap/report/addition.hpp"

namespace darwinop::gap {

/// Each number of [servo] that belongs to a joint becomes the effect that stands for it, in a section of that joint:
/// the other joints of `model` keep theirs. What no effect has, or has not in its range, stays a number of all joints.
Additions withJointNumbers(Additions additions, const twin::Model& model);

}  // namespace darwinop::gap
