// Writes actuations into MuJoCo's arrays, and reads the solved forces back.
#include "twin/body/joint_torques.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::twin {
namespace {

double finite(double value) noexcept {
  return std::isfinite(value) ? value : 0;
}

// Composite inertia about the joint axis at this pose, including armature.
double inertiaOf(const mjModel& m, const mjData& d, int dof) noexcept {
  return d.qM[m.dof_Madr[dof]];
}
// Apparent inertia for a sudden torque: smaller, because other joints yield. At the zero pose, without armature.
double apparentInertiaOf(const mjModel& m, int dof) noexcept {
  return 1 / m.dof_invweight0[dof];
}

// Owner of a friction row of the solver: dry friction of a joint, or the speed-controlled motor of a joint.
struct FrictionRow {
  int joint;  // -1: none
  bool motor;
};
FrictionRow frictionOf(const mjData& d, const BodyMap& map, int row) noexcept {
  const bool motor = d.efc_type[row] == mjCNSTR_FRICTION_TENDON;
  return {(motor ? map.joint_of_motor : map.joint_of_dof)[static_cast<std::size_t>(d.efc_id[row])], motor};
}

}  // namespace

JointTorques::JointTorques(mjModel& m, const BodyMap& map, const std::vector<Servo>& servos, bool hold_until_driven)
    : hold_{hold_until_driven} {
  std::array<double, kJoints> rigid{};
  std::array<LoadChange, kJoints> changes{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    changes[i] = servos[i].load();
    rotor_kgm2_[i] = servos[i].parameters().armature_kgm2 + changes[i].armature_kgm2;
    soft_[i] = servos[i].softGear();
    rigid[i] = soft_[i] ? 0 : rotor_kgm2_[i];
  }
  applyLoads(m, map, rigid, changes);
}

void JointTorques::reset(const mjData& d, const BodyMap& map) noexcept {
  acts_ = {};
  outside_nm_ = {};
  held_.fill(hold_);
  for (std::size_t i = 0; i < kJoints; ++i) {
    rest_rad_[i] = d.qpos[map.qpos[i]];
    gears_[i].reset(rest_rad_[i], 0, rotor_kgm2_[i]);
  }
}

double JointTorques::encoderRad(const Servo& servo, std::size_t i, double arm_rad) const noexcept {
  return soft_[i] ? gears_[i].encoderRad(servo.signals(), arm_rad) : arm_rad;
}

void JointTorques::act(mjModel& m, mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const int dof = map.dof[i];
    const double position = d.qpos[map.qpos[i]], velocity = d.qvel[dof];
    if (soft_[i]) {
      const ArmMotion arm{position, velocity, apparentInertiaOf(m, dof), outside_nm_[i]};
      acts_[i] = {.torque_nm = gears_[i].step(servos[i], arm, m.opt.timestep)};
    } else {
      acts_[i] = servos[i].actuate(position, velocity, outside_nm_[i]);
    }
    held_[i] = held_[i] && !servos[i].signals().torque_on;
    if (held_[i]) acts_[i].friction_nm = kStiffNm;
    const Actuation& act = acts_[i];
    d.qfrc_applied[dof] = finite(act.torque_nm);
    m.dof_damping[dof] = finite(act.damping_nms_rad);
    m.dof_frictionloss[dof] = finite(act.friction_nm);
    m.tendon_frictionloss[map.motor[i]] = act.follows_speed ? finite(act.speed_torque_nm) : 0;
    velocity_[i] = velocity;
  }
}

// Friction rows follow equality rows. The reference acceleration of a friction row is -B * velocity; towards a target
// speed it is B * (target - velocity). This is a stiff damper, under which a loaded joint creeps: 0.01 ticks in 10 s,
// 10 ticks where the joint carries only a light foot and the whole robot pulls. Therefore a joint at rest is also
// pulled back to where it stopped, by a bristle (spring) that bends up to the limit of the friction: 1e-6 rad, 1e-4 rad
// when a joint without armature holds 1 N m.
void JointTorques::setFrictionReferences(mjData& d, const BodyMap& map) noexcept {
  for (int row = d.ne; row < d.ne + d.nf; ++row) {
    const auto [joint, motor] = frictionOf(d, map, row);
    if (joint < 0) continue;
    const auto i = static_cast<std::size_t>(joint);
    const double damping = d.efc_KBIP[4 * row + 1];
    if (motor) {
      d.efc_aref[row] += damping * finite(acts_[i].speed_rad_s);
      continue;
    }
    const double stiffness = damping * damping / 4;              // critically damped
    const double give = d.efc_frictionloss[row] * d.efc_R[row];  // rad/s2: softness of the solver at the limit
    d.efc_aref[row] -= stiffness * bend(i, d.qpos[map.qpos[i]], {give / damping, give / stiffness});
  }
}

// Bend of the bristle, rad. `full`: creep speed and bend at the friction limit.
double JointTorques::bend(std::size_t i, double position, const Bristle& full) noexcept {
  constexpr Bristle kMin{.creep_rad_s = 1e-4, .bend_rad = 1e-6};  // above solver noise
  if (std::abs(velocity_[i]) > std::max(full.creep_rad_s, kMin.creep_rad_s)) rest_rad_[i] = position;
  const double max_bend = std::max(full.bend_rad, kMin.bend_rad);
  const double bent = std::clamp(position - rest_rad_[i], -max_bend, max_bend);
  rest_rad_[i] = position - bent;
  return bent;
}

void JointTorques::readSolverForces(const mjModel& m, const mjData& d, const BodyMap& map,
                                    std::vector<Servo>& servos) noexcept {
  std::array<double, kJoints> own{};
  // A motor with a torque limit of 0 has no row.
  for (std::size_t i = 0; i < kJoints; ++i)
    if (acts_[i].follows_speed) servos[i].noteMotorTorque(0);
  for (int row = d.ne; row < d.ne + d.nf; ++row) {
    const auto [joint, motor] = frictionOf(d, map, row);
    if (joint < 0) continue;
    const auto i = static_cast<std::size_t>(joint);
    own[i] += d.efc_force[row];
    if (motor) servos[i].noteMotorTorque(d.efc_force[row]);
  }
  for (std::size_t i = 0; i < kJoints; ++i) {
    const int dof = map.dof[i];
    const double acceleration = (d.qvel[dof] - velocity_[i]) / m.opt.timestep;
    own[i] += d.qfrc_applied[dof] - m.dof_damping[dof] * d.qvel[dof];  // MuJoCo damps the new velocity
    outside_nm_[i] = (soft_[i] ? apparentInertiaOf(m, dof) : inertiaOf(m, d, dof)) * acceleration - own[i];
  }
}

void JointTorques::step(mjModel& m, mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept {
  act(m, d, map, servos);
  mj_step1(&m, &d);
  setFrictionReferences(d, map);
  mj_step2(&m, &d);
  readSolverForces(m, d, map, servos);
}

}  // namespace darwinop::twin
