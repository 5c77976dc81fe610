#include "apps/calibrate/joints/gravity_model.hpp"

#include <mujoco/mujoco.h>

#include <cmath>
#include <vector>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::calibrate {

struct GravityModel::Parts {
  twin::MjModelPtr m;
  twin::MjDataPtr d;
  twin::BodyMap map;
  std::vector<mjtNum> torques;
};

GravityModel::GravityModel(const twin::Model& model) : parts_{std::make_unique<Parts>()} {
  parts_->m = twin::loadBody(model, /*ball=*/false);
  parts_->d = twin::dataFor(*parts_->m, model.body.xml);
  parts_->map = twin::mapBody(*parts_->m, model.body.xml);
  parts_->torques.resize(static_cast<std::size_t>(parts_->m->nv));
}

GravityModel::~GravityModel() = default;

JointValues GravityModel::holdingTorques(const JointValues& angles_rad, const std::array<double, 3>& up) {
  const mjModel& m = *parts_->m;
  mjData& d = *parts_->d;
  const twin::BodyMap& map = parts_->map;
  const mjtNum upright[4] = {1, 0, 0, 0};
  mju_copy4(d.qpos + map.trunk_qpos + 3, upright);
  for (std::size_t i = 0; i < kJoints; ++i) d.qpos[map.qpos[i]] = angles_rad[i];
  // The trunk's axes stay the world's, and gravity turns instead.
  const mjtNum strength = mju_norm3(m.opt.gravity);
  for (std::size_t i = 0; i < 3; ++i) parts_->m->opt.gravity[i] = -strength * up[i];
  mj_kinematics(&m, &d);
  mj_comPos(&m, &d);
  mj_comVel(&m, &d);
  mj_rne(&m, &d, /*flg_acc=*/0, parts_->torques.data());
  JointValues out{};
  for (std::size_t i = 0; i < kJoints; ++i) out[i] = parts_->torques[static_cast<std::size_t>(map.dof[i])];
  return out;
}

}  // namespace darwinop::calibrate
