#include "gap/benchmark/body/soft_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/plant/bench/surroundings.hpp"
#include "gap/plant/body/moving_imu.hpp"

namespace darwinop::gap {
namespace {

constexpr int kStepsPerCycle = 4;
constexpr double kWarmsBy = 6, kWarmsIn = 60;  // K, s
// The contact of the model sinks in by some hundredth of a millimetre under the robot's weight: so stiff is a spring
// whose period is that of the model's contact time over this.
constexpr double kStiffness = 5;
constexpr double kBristle = 2e-5;                // rad, bend at which dry friction gives way
constexpr double kBristleTime = 0.001;           // s, damping of the bristle over its stiffness
constexpr double kStop = 300, kStopDamping = 1;  // N m/rad, N m s/rad

FloorHypothesis robotOf(const BodyTruth& truth, const BodyLog& log) {
  FloorHypothesis out = truth.model.robot;
  if (truth.loose && log.session_start_s >= truth.loose_from_s) out.robot.links.push_back(*truth.loose);
  if (log.setup == BodySetup::kClamped) out.floor.tilt_rad = {};
  return out;
}

}  // namespace

SoftBody::SoftBody(BodyCase& plan, std::size_t log, const BodyTruth& truth, const Disturbance* noise)
    : plan_{plan},
      log_index_{log},
      log_{plan.logs[log]},
      truth_{truth},
      noise_{noise},
      period_{truth.model.robot.robot.servos.servo.firmware_period_s},
      ambient_c_{truth.model.robot.robot.servos.servo.ambient_c +
                 kWarmsBy * (1 - std::exp(-plan.logs[log].session_start_s / kWarmsIn))},
      dt_{period_ / kStepsPerCycle},
      model_{bodyOf(plan.joints.model, robotOf(truth, plan.logs[log]))},
      map_{twin::mapBody(*model_, plan.joints.model.body.xml)},
      contacts_{*model_, map_} {
  const BodyHypothesis& robot = truth.model.robot.robot;
  std::array<double, kJoints> rotor{};
  std::array<twin::LoadChange, kJoints> changes{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    Disturbance own = noise == nullptr ? Disturbance{} : *noise;
    own.seed = splitMix(own.seed * kJoints + i);
    if (noise != nullptr) joint_noise_.emplace_back(own, own.seed, period_, 2 * kPi / robot.servos.servo.ticks_per_rev);
    servos_.push_back(servoOf(robot, static_cast<Joint>(i), noise == nullptr,
                              std::make_unique<Surroundings>(ambient_c_, noise == nullptr ? nullptr : &own, period_)));
    changes[i] = servos_[i].load();
    soft_[i] = servos_[i].softGear();
    rotor[i] = servos_[i].parameters().armature_kgm2 + changes[i].armature_kgm2;
    gears_[i].reset(rowsOf(i).goal_rad.front(), 0, rotor[i]);
    if (soft_[i]) rotor[i] = 0;
  }
  twin::applyLoads(*model_, map_, rotor, changes);
  mjModel& m = *model_;
  m.opt.timestep = dt_;
  const twin::BodySettings& body = plan.joints.model.body;
  const double contact_s = body.contact_time_s * truth.model.robot.floor.contact_time_factor / kStiffness;
  double point_kg = 0;
  for (int b = 0; b < m.nbody; ++b) point_kg += m.body_mass[b] / 8;  // corners of two soles
  contact_ = {.stiffness_n_m = point_kg / (contact_s * contact_s),
              .damping_ns_m = 2 * point_kg / contact_s,
              .friction = body.floor_friction * truth.model.robot.floor.friction_factor};
  if (isClamped()) first_ = 6;
  data_ = twin::dataFor(m, body.xml);
  imu_ = std::make_unique<twin::Imu>(m, map_, tracedSensors(plan.joints.model.imu), 0);
  twin::orThrow(body.xml, [&] { place(); });
  imu_->reset(m, *data_);
}

void SoftBody::place() {
  mjModel& m = *model_;
  mjData& d = *data_;
  std::array<double, kJoints> pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = rowsOf(i).goal_rad.front();
  placeAtRest(m, d, map_, pose, log_.lies_on);
  if (isClamped() && log_.up) {
    const Axes& up = *log_.up;
    const Eigen::Quaterniond turned =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d{up[0], up[1], up[2]}, Eigen::Vector3d::UnitZ());
    mjtNum* const quat = d.qpos + map_.trunk_qpos + 3;
    quat[0] = turned.w(), quat[1] = turned.x(), quat[2] = turned.y(), quat[3] = turned.z();
    d.qpos[map_.trunk_qpos + 2] = 2;
  }
  const double held = isClamped() ? kHeldClamped : kHeldFree;
  for (std::size_t i = 0; i < kJoints; ++i) servos_[i].reset(pose[i], log_.session_start_s - held);
}

void SoftBody::writeRow(std::size_t row) {
  for (std::size_t i = 0; i < kJoints; ++i) takeRow(rowsOf(i), row, drives_[i]);
}

void SoftBody::cycle() {
  mjData& d = *data_;
  double drawn_a = 0;
  for (const twin::Servo& servo : servos_) drawn_a += servo.signals().duty * servo.signals().current_a;
  const double battery_v = log_.battery_v - truth_.battery_ohm * drawn_a;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double arm = d.qpos[map_.qpos[i]];
    double seen = soft_[i] ? gears_[i].encoderRad(servos_[i].signals(), arm) : arm;
    ServoDrive drive = drives_[i];
    drive.supply_v = battery_v;
    if (!joint_noise_.empty()) {
      seen += joint_noise_[i].encoder_rad * joint_noise_[i].encoder.normal();
      drive.supply_v += joint_noise_[i].supply_v.next();
    }
    supply_v_[i] = drive.supply_v;
    servos_[i].firmware(drive, seen, d.qvel[map_.dof[i]]);
  }
  accel_m_s2_ = {};
  for (int i = 0; i < kStepsPerCycle; ++i) {
    step(time_s_);
    time_s_ += dt_;
    imu_->update(*model_, d);
    const twin::Imu::Axes now = imu_->accelerometer(*model_, d, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) accel_m_s2_[axis] += now[axis] / kStepsPerCycle;
  }
}

void SoftBody::act() {
  const mjModel& m = *model_;
  const mjData& d = *data_;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double position = d.qpos[map_.qpos[i]], velocity = d.qvel[map_.dof[i]];
    if (soft_[i]) {
      const twin::ArmMotion arm{position, velocity, 1 / m.dof_invweight0[map_.dof[i]], outside_nm_[i]};
      acts_[i] = {.torque_nm = gears_[i].step(servos_[i], arm, dt_)};
    } else {
      acts_[i] = servos_[i].actuate(position, velocity, outside_nm_[i]);
    }
  }
}

void SoftBody::addFriction(std::vector<SoftRow>& rows) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double limit = acts_[i].friction_nm, stiffness = limit / kBristle;
    rows.push_back({.direction = Eigen::VectorXd::Unit(model_->nv - first_, of(map_.dof[i])),
                    .stiffness = stiffness,
                    .damping = kBristleTime * stiffness,
                    .bend = bend_[i],
                    .limit = limit});
  }
}

void SoftBody::addStops(std::vector<SoftRow>& rows) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double at = data_->qpos[map_.qpos[i]];
    const int joint = model_->dof_jntid[map_.dof[i]];
    const double low = model_->jnt_range[2 * joint], high = model_->jnt_range[2 * joint + 1];
    if (at > low && at < high) continue;
    const double sign = at <= low ? 1 : -1;
    rows.push_back({.direction = sign * Eigen::VectorXd::Unit(model_->nv - first_, of(map_.dof[i])),
                    .stiffness = kStop,
                    .damping = kStopDamping,
                    .bend = sign > 0 ? at - low : high - at,
                    .only_pushes = true});
  }
}

void SoftBody::step(double time_s) {
  mjModel& m = *model_;
  mjData& d = *data_;
  const Eigen::Index n = m.nv - first_;
  mj_kinematics(&m, &d);
  mj_comPos(&m, &d);
  mj_crb(&m, &d);
  mj_comVel(&m, &d);
  Eigen::VectorXd bias(m.nv);
  mj_rne(&m, &d, 0, bias.data());
  Eigen::MatrixXd mass(m.nv, m.nv);
  mj_fullM(&m, mass.data(), d.qM);
  act();
  Eigen::VectorXd force = -bias.tail(n), damping = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < kJoints; ++i) {
    force[of(map_.dof[i])] += acts_[i].torque_nm;
    damping[of(map_.dof[i])] = acts_[i].damping_nms_rad;
  }
  if (truth_.outside) {
    const Disturber& outside = *truth_.outside;
    if (outside.joint) {
      const auto i = static_cast<std::size_t>(*outside.joint);
      force[of(map_.dof[i])] += outside.torque_nm(d.qpos[map_.qpos[i]]);
    } else if (!isClamped() && outside.file == log_.file && time_s >= outside.from_s && time_s < outside.to_s) {
      force.head(3) += outside.push_n;
    }
  }
  std::vector<SoftRow> rows;
  addFriction(rows);
  addStops(rows);
  if (!isClamped()) contacts_.addTo(rows, m, d, first_, contact_);
  const Eigen::Map<Eigen::VectorXd> velocity{d.qvel + first_, n};
  const Eigen::VectorXd before = velocity;
  const Eigen::VectorXd after = stepped(mass.bottomRightCorner(n, n), damping, before, force, dt_, rows);
  for (std::size_t i = 0; i < kJoints; ++i) bend_[i] = rows[i].bend_new;
  contacts_.keepBends(rows);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const Eigen::Index k = of(map_.dof[i]);
    const double inertia = soft_[i] ? 1 / m.dof_invweight0[map_.dof[i]] : mass(map_.dof[i], map_.dof[i]);
    const double own = acts_[i].torque_nm - acts_[i].damping_nms_rad * after[k] + rows[i].force;
    outside_nm_[i] = inertia * (after[k] - before[k]) / dt_ - own;
  }
  // Positions by the mean speed: a fall has no lag of half a step.
  Eigen::Map<Eigen::VectorXd> speed{d.qvel + first_, n};
  speed = (before + after) / 2;
  mj_integratePos(&m, d.qpos, d.qvel, dt_);
  speed = after;
}

}  // namespace darwinop::gap
