// Compiled MuJoCo model of the robot, and the indices of its parts in MuJoCo's arrays.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/joints.hpp"
#include "twin/model/model.hpp"
#include "twin/servo/signals.hpp"

namespace darwinop::twin {

struct MjModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct MjDataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MjModelPtr = std::unique_ptr<mjModel, MjModelDeleter>;
using MjDataPtr = std::unique_ptr<mjData, MjDataDeleter>;

/// Dry friction that holds a joint against any load of this robot, N m.
inline constexpr double kStiffNm = 1000;

/// Indices into MuJoCo's arrays; joints in the order of the servo ids.
struct BodyMap {
  int trunk = -1;       // body; its free joint has the addresses below
  int trunk_qpos = -1;  // x y z, then the quaternion w x y z
  int trunk_dof = -1;   // velocity in the world frame, then angular rate in the trunk frame
  std::array<int, kJoints> qpos{}, dof{}, link{}, motor{};
  std::vector<int> joint_of_dof, joint_of_motor;  // inverse maps; -1: none
  int gyro = -1, accelerometer = -1;              // sites
  int floor = -1;                                 // geom
  int ball_qpos = -1, ball_dof = -1;              // -1: there is no ball
};

/// Loads the body of `model`; `ball` false removes the ball. Throws std::runtime_error with the file and the reason.
MjModelPtr loadBody(const Model& model, bool ball);
/// Allocates the simulation state. Throws std::runtime_error without memory.
MjDataPtr dataFor(const mjModel& m, const std::string& file);
/// Throws std::runtime_error for a missing joint, body or site. `file`: for the message.
BodyMap mapBody(const mjModel& m, const std::string& file);

/// Sets the armatures of the joints and applies the load changes to the link of each joint.
void applyLoads(mjModel& m, const BodyMap& map, const std::array<double, kJoints>& rotor_kgm2,
                const std::array<LoadChange, kJoints>& changes);

}  // namespace darwinop::twin
