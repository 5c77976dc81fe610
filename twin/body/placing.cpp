// Places the robot on the floor: lowest point of its geoms, pose, settling.
#include "twin/body/placing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/conversions.hpp"
#include "twin/body/mujoco_guard.hpp"

namespace darwinop::twin {
namespace {

// Extent of a geom below its centre, m.
double reach(int type, const mjtNum* size, const mjtNum* rotation) {
  const double up[3] = {std::abs(rotation[6]), std::abs(rotation[7]), std::abs(rotation[8])};
  switch (type) {
    case mjGEOM_BOX:
      return up[0] * size[0] + up[1] * size[1] + up[2] * size[2];
    case mjGEOM_CAPSULE:
      return size[0] + up[2] * size[1];
    case mjGEOM_SPHERE:
      return size[0];
    case mjGEOM_CYLINDER:
      return std::hypot(up[0], up[1]) * size[0] + up[2] * size[1];
    case mjGEOM_ELLIPSOID:
      return std::hypot(up[0] * size[0], up[1] * size[1], up[2] * size[2]);
    default:
      return 0;
  }
}

}  // namespace

std::array<double, kJoints> startPose() {
  std::array<double, kJoints> angles{};
  for (std::size_t i = 0; i < kJoints; ++i) angles[i] = radFromTicks(kJointTable[i].start).value;
  return angles;
}

double lowestPoint(const mjModel& m, const mjData& d, int trunk) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int g = 0; g < m.ngeom; ++g)
    if (m.body_rootid[m.geom_bodyid[g]] == trunk && m.geom_contype[g] != 0)
      lowest =
          std::min(lowest, d.geom_xpos[3 * g + 2] - reach(m.geom_type[g], m.geom_size + 3 * g, d.geom_xmat + 9 * g));
  return lowest;
}

void bringToRest(const mjModel& m, mjData& d, const BodyMap& map, const std::array<double, kJoints>& angles_rad) {
  mju_zero(d.qvel + map.trunk_dof, 6);
  for (std::size_t i = 0; i < kJoints; ++i) {
    d.qpos[map.qpos[i]] = angles_rad[i];
    d.qvel[map.dof[i]] = 0;
  }
  mju_zero(d.qacc_warmstart, m.nv);
  mju_zero(d.qfrc_applied, m.nv);
  mju_zero(d.xfrc_applied, 6 * m.nbody);
}

void placeOnFloor(const mjModel& m, mjData& d, const BodyMap& map, const std::array<double, kJoints>& angles_rad,
                  double pitch_rad) {
  bringToRest(m, d, map, angles_rad);
  mju_zero3(d.qpos + map.trunk_qpos);
  // Trunk axes x, y, z are left, up, forward; a rotation about the world's y (left) pitches it forward.
  const mjtNum axes[4] = {0.5, 0.5, 0.5, 0.5};
  const mjtNum left[3] = {0, 1, 0};
  mjtNum lean[4];
  mju_axisAngle2Quat(lean, left, pitch_rad);
  mju_mulQuat(d.qpos + map.trunk_qpos + 3, lean, axes);
  mj_kinematics(&m, &d);
  d.qpos[map.trunk_qpos + 2] = -lowestPoint(m, d, map.trunk);
  mj_kinematics(&m, &d);
}

void settleOnFloor(mjModel& m, mjData& d, const BodyMap& map, double seconds) {
  std::array<double, kJoints> angles{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    angles[i] = d.qpos[map.qpos[i]];
    m.dof_damping[map.dof[i]] = 0;
    m.dof_frictionloss[map.dof[i]] = kStiffNm;
  }
  const mjtNum time = d.time;
  orThrow("start pose", [&] {
    for (int i = 0; i < std::lround(seconds / m.opt.timestep); ++i) mj_step(&m, &d);
  });
  d.time = time;
  for (std::size_t i = 0; i < kJoints; ++i) {
    m.dof_frictionloss[map.dof[i]] = 0;  // servo friction is set in the next step
    d.qpos[map.qpos[i]] = angles[i];
    d.qvel[map.dof[i]] = 0;
  }
  mju_zero(d.qvel + map.trunk_dof, 6);
  d.qpos[map.trunk_qpos] = d.qpos[map.trunk_qpos + 1] = 0;
}

}  // namespace darwinop::twin
