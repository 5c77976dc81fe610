// The compiled body: read from its XML, changed as the model file says, and where things are in MuJoCo's arrays.
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

/// Dry friction that holds a joint whatever pulls at it, N m: no load of this robot comes near it.
inline constexpr double kStiffNm = 1000;

/// Indices into MuJoCo's arrays; of joints in the order of the servo ids.
struct BodyMap {
  int trunk = -1;       // body; its free joint has the addresses below
  int trunk_qpos = -1;  // x y z, then the quaternion w x y z
  int trunk_dof = -1;   // velocity in the world, then turning rate in the trunk's frame
  std::array<int, kJoints> qpos{}, dof{}, link{}, motor{};
  std::vector<int> joint_of_dof, joint_of_motor;  // the other way round; -1: of no joint
  int gyro = -1, accelerometer = -1;              // sites
  int floor = -1;                                 // geom
  int ball_qpos = -1, ball_dof = -1;              // -1: there is no ball
};

/// Throws std::runtime_error, with the file and what MuJoCo or this program misses in it. `ball`: false takes it away.
MjModelPtr loadBody(const Model& model, bool ball);
/// Room for its state. Throws std::runtime_error when there is not enough.
MjDataPtr dataFor(const mjModel& m, const std::string& file);
/// Throws std::runtime_error that names the joint, body or site that is missing. `file` is for that sentence.
BodyMap mapBody(const mjModel& m, const std::string& file);

/// Rotors as armatures of the joints, and what effects change of the link that hangs on each joint.
void applyLoads(mjModel& m, const BodyMap& map, const std::array<double, kJoints>& rotor_kgm2,
                const std::array<LoadChange, kJoints>& changes);

}  // namespace darwinop::twin
