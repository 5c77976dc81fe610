// A trunk that is clamped does not turn: what its gyroscope shows of a stand that gives way, or of a robot held by
// hand.
#pragma once

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kTrunkShakes = " rad/s although it is clamped; tighten the stand and record again";
inline constexpr const char* kTrunkTurns =
    " rad although it is clamped, so that `up` is wrong for a part of the recording; tighten the stand and record "
    "again";
}  // namespace messages

/// rad/s about the median, five steps of the register: a clamped trunk does not turn as fast.
inline constexpr double kClampedRate = 0.3;

/// Of the gyroscope's axes about their medians, rad/s.
double greatestRate(const AxesColumns& gyro);
/// The farthest that any axis turns within the log, rad; a bias does not count.
double greatestTurn(const BodyLog& log);

}  // namespace darwinop::gap
