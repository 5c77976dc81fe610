// A case of one joint of a robot: recordings of experiments, and the robot's model for it.
#pragma once

#include <string>
#include <vector>

#include "core/joints.hpp"

namespace darwinop::gap {

namespace messages {
inline constexpr const char* kTakenAsUpright = "; there is no accelerometer: the trunk counts as upright";
inline constexpr const char* kSupplyOfModel = "; no voltage is known: the supply is that of the model";
}  // namespace messages

struct JointCaseRequest {
  std::string model = "darwin-op";  // a model file, or the name of a shipped one
  Joint joint = Joint::kShoulderR;
  std::vector<std::string> recordings;  // to be fitted
  std::vector<std::string> held_out;    // not fitted: to verify the result
};

/// Sentences for the user.
struct JointCaseNotes {
  std::vector<std::string> logs;      // what each log of the case is
  std::vector<std::string> warnings;  // about the recordings, such as one that was cut off
};

/// Makes the folder: case.json, model.ini, and a log for each part in which the joint moves alone. The pendulum that
/// the joint swings is that of the model's body, in the pose and at the tilt of each recording, upright without a
/// board; the supply is the board's or the joint's. Throws std::runtime_error with a sentence.
JointCaseNotes writeJointCase(const JointCaseRequest& request, const std::string& folder);

}  // namespace darwinop::gap
