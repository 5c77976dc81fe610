// Where a released arm falls: to where it hangs, if its angles count from there.
#pragma once

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// rad, from -pi to pi: where an arm comes to rest that is released while it holds still, and moves away from 0, median
/// of the stretches of a log; NaN: there is none. Gravity pulls elsewhere: friction can stop an arm on its way to where
/// it hangs, but not drive it away.
double restBeyondRelease(const Trajectory& log);

}  // namespace darwinop::gap
