// Computes the pendulum equivalent to one joint of the body.
#include "twin/body/pendulum.hpp"

#include <mujoco/mujoco.h>

#include <cmath>
#include <vector>

#include "core/units.hpp"
#include "twin/body/mujoco_guard.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {
namespace {

/// Aligns the trunk with the world and sets gravity from the accelerometer. Trunk axes: left, up, forward.
void setGravity(mjModel& m, mjData& d, const BodyMap& map, const std::array<double, 3>& accel) {
  const double magnitude = mju_norm3(m.opt.gravity), measured = std::hypot(accel[0], accel[1], accel[2]);
  const double down[3] = {accel[0], -accel[2], -accel[1]};
  for (int k = 0; k < 3; ++k) m.opt.gravity[k] = down[k] / measured * magnitude;
  const double upright[4] = {1, 0, 0, 0};
  mju_copy4(d.qpos + map.trunk_qpos + 3, upright);
}

/// The body on the trunk that carries `body`: arms, legs and head are one each.
int limbOf(const mjModel& m, const BodyMap& map, int body) {
  while (m.body_parentid[body] != map.trunk && m.body_parentid[body] != 0) body = m.body_parentid[body];
  return body;
}

}  // namespace

JointPendulum pendulumOf(const Model& model, Joint joint, const std::array<double, kJoints>& angles_rad,
                         const std::array<double, 3>& accel_m_s2) {
  const MjModelPtr body = loadBody(model, /*ball=*/false);
  mjModel& m = *body;
  const MjDataPtr data = dataFor(m, model.body.xml);
  mjData& d = *data;
  const BodyMap map = mapBody(m, model.body.xml);
  m.opt.disableflags |= mjDSBL_CONSTRAINT;
  setGravity(m, d, map, accel_m_s2);
  const auto i = static_cast<std::size_t>(joint);
  for (std::size_t other = 0; other < kJoints; ++other) {
    const bool is_known = !std::isnan(angles_rad[other]);
    if (!is_known && other != i && limbOf(m, map, map.link[other]) == limbOf(m, map, map.link[i]))
      throw std::runtime_error(std::string{kJointTable[other].name} + messages::kAngleUnknown +
                               std::string{kJointTable[i].name} + " depends on its angle; check its cable");
    d.qpos[map.qpos[other]] = is_known ? angles_rad[other] : 0;  // that of another limb has no effect
  }
  const int dof = map.dof[i];
  // Holding torque: weight sin(q - hangs_at).
  std::array<double, 2> holding{};
  std::vector<double> inertia(static_cast<std::size_t>(m.nv) * static_cast<std::size_t>(m.nv));
  orThrow(model.body.xml, [&] {
    for (int k = 0; k < 2; ++k) {
      d.qpos[map.qpos[i]] = k * kPi / 2;
      mj_forward(&m, &d);
      holding[static_cast<std::size_t>(k)] = d.qfrc_bias[dof];
    }
    mj_fullM(&m, inertia.data(), d.qM);
  });
  const double own = inertia[static_cast<std::size_t>(dof) * static_cast<std::size_t>(m.nv + 1)];
  return {.weight_nm = std::hypot(holding[0], holding[1]),
          .hangs_at_rad = std::atan2(-holding[0], holding[1]),
          .inertia_kgm2 = own - m.dof_armature[dof]};
}

}  // namespace darwinop::twin
