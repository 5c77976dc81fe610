// Data structure of an experiment: joints, goals, recorded columns. File format: docs/experiments.md.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/joints.hpp"
#include "core/servo_limits.hpp"

namespace darwinop::experiments {

using Pose = std::array<double, kJoints>;  // rad

/// A named pose, for [setup].
struct NamedPose {
  std::string_view name, what;
  Pose pose;
  bool on_feet;  // standing, so the robot can fall
};
const std::array<NamedPose, 2>& namedPoses();
/// The kneeling start pose, stable without torque.
const Pose& startPose();

struct Moved {
  Joint joint{};
  double sign = 1;  // -1: mirrored, "-AnkleL"
  bool operator==(const Moved&) const = default;
};

/// `joints = all`.
inline constexpr std::string_view kAllJoints = "all";
/// What a phase moves with it: left joints are mirrored.
inline std::vector<Moved> allMoved() {
  std::vector<Moved> out;
  for (std::size_t i = 0; i < kJoints; ++i)
    out.push_back({static_cast<Joint>(i), kJointTable[i].name.ends_with('L') ? -1.0 : 1.0});
  return out;
}

/// Trajectory of the goal in a phase.
enum class Shape : std::uint8_t { kHold, kStep, kSteps, kRamp, kMove, kTriangle, kSine, kChirp, kMultisine };
inline constexpr std::array<std::string_view, 9> kShapeNames{"hold",     "step", "steps", "ramp",     "move",
                                                             "triangle", "sine", "chirp", "multisine"};

struct Goal {
  Shape shape = Shape::kHold;
  double to = 0;                // rad; step, ramp, move
  double amplitude = 0;         // rad
  double period_s = 0;          // triangle
  std::vector<double> hz;       // sine: one; chirp: start and end; multisine: all
  std::vector<double> goals;    // rad; steps
  std::vector<double> every_s;  // steps: one for all, or one per goal
};

enum class TorqueMode : std::uint8_t {
  kLimit,   // position goal with a torque limit
  kDirect,  // Motor::setTorque, no position goal
  kOff,     // limp
};

/// A value that changes linearly over the phase.
struct Slope {
  double begin = 0, end = 0;
  [[nodiscard]] double at(double share) const { return begin + (end - begin) * share; }
};

enum class Until : std::uint8_t { kTime, kArrival, kRest, kFallen };
inline constexpr std::array<std::string_view, 4> kUntilNames{"time", "arrival", "rest", "fallen"};

struct Phase {
  std::string name;
  int line = 0, goal_line = 0;  // of the section; of the key that sets the goal
  std::vector<Moved> joints;
  Goal goal;
  double duration_s = 0;  // maximum
  double velocity = kFullSpeed;
  double acceleration = -1;       // rad/s2; -1: none
  double p_gain = kDefaultPGain;  // Webots P; the register is 8 times as much
  TorqueMode torque = TorqueMode::kLimit;
  Slope newton_meter{kMaxTorqueNm,
                     kMaxTorqueNm};  // limit, or torque; sign as in Webots: positive turns to lower angles
  Until until = Until::kTime;
  double within = 0;                // rad; arrival
  std::optional<double> arrive_at;  // rad; arrival
};

struct ExperimentSetup {
  int line = 0;
  std::array<int, kJoints> line_of{};  // of a joint set in the file; 0: from the named pose
  const NamedPose* named = nullptr;
  Pose pose{};  // named pose with the joints set in the file
  double duration_s = 0, settle_s = 0;
  bool is_clamped = false;  // the trunk is held in a stand: the robot cannot fall, however it is turned
};

/// The phases with one value of the sweep.
struct Round {
  std::string label;  // "velocity = 2 rad/s", empty without a sweep
  std::vector<Phase> phases;
};

struct Experiment {
  std::string file, name, title, source;
  std::vector<std::string> description;
  ExperimentSetup setup;
  std::vector<Round> rounds;
  std::vector<Joint> record_joints;
  std::vector<std::string> record_sensors;  // "gyro", "accelerometer"
};

}  // namespace darwinop::experiments
