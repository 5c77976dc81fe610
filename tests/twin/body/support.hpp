// Robots and measuring tools for the tests of the body.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <string>

#include "core/conversions.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::twin::test {

inline constexpr Nanos kStep{1'000'000};
inline constexpr double kGravity = 9.81;  // of the body file: MuJoCo's own
using Vec = std::array<double, 3>;
using Pose = std::array<double, kJoints>;

/// The shipped body; servos without any friction unless asked.
inline Model modelWith(double dry_friction_nm = 0, double damping_nms_rad = 0) {
  Model model;
  model.name = "test";
  model.folder = DARWINOP_MODELS;
  model.body.trunk_com = TrunkCom::kManufacturer;
  if (dry_friction_nm > 0) model.effects.push_back({findEffect("coulomb"), {dry_friction_nm}, {}});
  if (damping_nms_rad > 0) model.effects.push_back({findEffect("viscous"), {damping_nms_rad}, {}});
  return model;
}

inline Drives limp() {
  return {};
}
inline Drives holding(const Pose& goal, double p_gain = 4) {
  Drives drives{};
  for (std::size_t i = 0; i < kJoints; ++i)
    drives[i] = {.torque_on = true,
                 .goal_rad = goal[i],
                 .speed_limit_rad_s = std::numeric_limits<double>::infinity(),
                 .torque_limit = 1,
                 .p_gain = p_gain};
  return drives;
}

inline void run(RobotBody& body, const Drives& drives, double seconds) {
  for (int i = 0; i < std::lround(seconds * 1000); ++i) body.step(kStep, drives);
}

/// Tests may bend the model: other gravity, a heavier trunk.
inline mjModel& bend(RobotBody& body) {
  return const_cast<mjModel&>(*body.mujocoModel());
}
inline int idOf(RobotBody& body, mjtObj kind, const std::string& name) {
  const int id = mj_name2id(body.mujocoModel(), kind, name.c_str());
  EXPECT_GE(id, 0) << name;
  return id;
}
inline int dofOf(RobotBody& body, Joint joint) {
  const mjModel& m = *body.mujocoModel();
  return m.jnt_dofadr[idOf(body, mjOBJ_JOINT, std::string{row(joint).name})];
}
inline int qposOf(RobotBody& body, Joint joint) {
  const mjModel& m = *body.mujocoModel();
  return m.jnt_qposadr[idOf(body, mjOBJ_JOINT, std::string{row(joint).name})];
}
inline double angleOf(RobotBody& body, Joint joint) {
  return body.mujocoData()->qpos[qposOf(body, joint)];
}
/// Position and speed of the trunk's free joint.
inline mjtNum* trunkQpos(RobotBody& body) {
  const mjModel& m = *body.mujocoModel();
  return body.mujocoData()->qpos + m.jnt_qposadr[idOf(body, mjOBJ_JOINT, "Body")];
}
inline mjtNum* trunkQvel(RobotBody& body) {
  const mjModel& m = *body.mujocoModel();
  return body.mujocoData()->qvel + m.jnt_dofadr[idOf(body, mjOBJ_JOINT, "Body")];
}
/// A point of the world as the trunk sees it: left, up, forward.
inline Vec inTrunk(RobotBody& body, const mjtNum* point) {
  const mjData& d = *body.mujocoData();
  const int trunk = idOf(body, mjOBJ_BODY, "Body");
  mjtNum from[3], seen[3];
  mju_sub3(from, point, d.xpos + 3 * trunk);
  mju_rotVecMatT(seen, from, d.xmat + 9 * trunk);
  return {seen[0], seen[1], seen[2]};
}
/// Puts all joints there, without dynamics.
inline void pose(RobotBody& body, const Pose& angles) {
  for (std::size_t i = 0; i < kJoints; ++i) body.mujocoData()->qpos[qposOf(body, static_cast<Joint>(i))] = angles[i];
  mj_forward(body.mujocoModel(), body.mujocoData());
}
/// So high that nothing touches for a while.
inline void lift(RobotBody& body, double height_m = 100) {
  trunkQpos(body)[2] = height_m;
}
/// A trunk that hangs in the air and gives way to nothing, as on a stand; joints at rest at these angles.
inline void hangUp(RobotBody& body, const Pose& angles = {}) {
  constexpr double kHeavy = 1e3;
  mjModel& m = bend(body);
  const int trunk = idOf(body, mjOBJ_BODY, "Body");
  m.body_mass[trunk] = kHeavy;
  for (int k = 0; k < 3; ++k) m.body_inertia[3 * trunk + k] = kHeavy;
  mju_zero3(m.body_ipos + 3 * trunk);
  mj_setConst(&m, body.mujocoData());
  body.place(angles);
  lift(body);
  const double weight_n = m.body_subtreemass[trunk] * kGravity;
  body.push({0, 0, weight_n}, Nanos{std::chrono::hours{1}});
}

}  // namespace darwinop::twin::test
