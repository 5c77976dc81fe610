// Looks at a recording right after it was made, while the robot still lies as it was.
#pragma once

#include <string>
#include <vector>

#include "experiments/format/experiment.hpp"
#include "experiments/logs/log.hpp"
#include "gap/plant/body/resting_imu.hpp"
#include "gap/record/recordings.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kDrivenNeverAnswers =
    " is commanded and never answers; check its cable, or name it in `absent` of robot.ini";
}  // namespace messages

/// What of a recording is used: from when all joints have held the setup pose for a second, to the end of the phases.
/// Fills from_s, to_s and the battery's voltage. Throws BadInput, a sentence, where the robot never held the pose.
void findUsedRows(const logs::Log& recording, const experiments::Pose& pose, double phases_s, MadeRecording& made);

/// Sentences on what is wrong with it, each with what to do; none: it is good. Throws BadInput where it cannot be read
/// at all. `imu`: of the model, shows whether the robot lies as it was asked to.
std::vector<std::string> problemsOf(const logs::Log& recording, const std::string& model, const RestingImu& imu,
                                    const MadeRecording& made);

}  // namespace darwinop::gap
