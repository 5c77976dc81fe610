// Where a released arm comes to rest: hanging, if its angles count from there.
#pragma once

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// rad, from -pi to pi: median of the stretches of a log in which the arm is released, falls and is still at the end;
/// NaN: there is none.
double restAngle(const Trajectory& log);

/// rad: dry friction of the model holds an arm no farther from where it hangs, with a margin for more of it.
double farthestRest(const Case& c, const Trajectory& log);

}  // namespace darwinop::gap
