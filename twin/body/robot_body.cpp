// Robot simulation step: servos, physics, sensors.
#include "twin/body/robot_body.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "twin/body/ball.hpp"
#include "twin/body/imu.hpp"
#include "twin/body/joint_torques.hpp"
#include "twin/body/mujoco_guard.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/body/placing.hpp"

namespace darwinop::twin {
namespace {

// The start pose kneels on soles and shins; the soles are level at this pitch of the trunk.
constexpr double kStartLeanRad = 0.13;
// Left and right ankle differ by 1.1 degrees in the start pose, so the robot rolls slightly before it is at rest.
constexpr double kSettleSeconds = 0.5;

std::int64_t nanosOf(double seconds) {
  return std::llround(seconds * 1e9);
}

// s; maximum step with elastic transmissions: tooth contact lasts a fraction of a millisecond.
constexpr double kMaxElasticStep = 0.00025;

std::vector<Servo> servosOf(const Model& model) {
  std::vector<Servo> servos;
  servos.reserve(kJoints);
  for (std::size_t i = 0; i < kJoints; ++i) servos.emplace_back(model.servo, effectsOf(model, static_cast<Joint>(i)));
  return servos;
}

// Divides the model's step into equal parts if a transmission requires it.
Model withStepFor(Model model, const std::vector<Servo>& servos) {
  if (std::ranges::any_of(servos, &Servo::softGear))
    model.body.step_s /= std::max(1.0, std::ceil(model.body.step_s / kMaxElasticStep - 1e-9));
  return model;
}

}  // namespace

struct RobotBody::Parts {
  Parts(const Model& requested, const RobotBodyOptions& options)
      : servos{servosOf(requested)},
        model{withStepFor(requested, servos)},
        m{loadBody(model, options.ball != Ball::kNone)},
        map{mapBody(*m, model.body.xml)},
        torques{*m, map, servos, model.body.hold_until_driven},
        d{dataFor(*m, model.body.xml)},
        imu{*m, map, model.imu, options.seed},
        ball_circles{options.ball == Ball::kCircles},
        step_ns{nanosOf(model.body.step_s)},
        firmware_ns{nanosOf(model.servo.firmware_period_s)} {}

  void physicsStep(const Drives& drives) noexcept;
  void placeAt(const std::array<double, kJoints>& angles_rad, double lean_rad, double settle_s = 0);
  void publish() noexcept;
  void checkWarnings() noexcept;
  void stopSimulation(const char* why) noexcept;

  std::vector<Servo> servos;
  Model model;
  MjModelPtr m;
  BodyMap map;
  JointTorques torques;
  MjDataPtr d;
  Imu imu;
  bool ball_circles;
  std::int64_t step_ns, firmware_ns;
  std::int64_t now_ns = 0, next_firmware_ns = 0, pending_ns = 0, push_until_ns = 0;
  std::uint64_t samples = 0;
  BodyState state;
  std::array<char, 400> error{};
};

// Warnings after which the simulation is invalid. MuJoCo only counts them, then resets the state or drops contacts.
void RobotBody::Parts::checkWarnings() noexcept {
  for (const mjtWarning kind :
       {mjWARN_INERTIA, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL, mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
    if (d->warning[kind].number > 0) return stopSimulation(mju_warningText(kind, d->warning[kind].lastinfo));
}

void RobotBody::Parts::stopSimulation(const char* why) noexcept {
  std::snprintf(
      error.data(), error.size(),
      "the simulation stopped at %.3f s, the robot no longer moves: %.120s. Check the model for extreme values, or "
      "reduce [body] step",
      static_cast<double>(now_ns) * 1e-9, why);
}

void RobotBody::Parts::physicsStep(const Drives& drives) noexcept {
  mjData& data = *d;
  for (; next_firmware_ns <= now_ns; next_firmware_ns += firmware_ns)
    for (std::size_t i = 0; i < kJoints; ++i)
      servos[i].firmware(drives[i], torques.encoderRad(servos[i], i, data.qpos[map.qpos[i]]), data.qvel[map.dof[i]]);
  if (ball_circles) moveBallOnCircle(data, map, static_cast<double>(now_ns) * 1e-9);
  torques.step(*m, data, map, servos);
  now_ns += step_ns;
  ++samples;
  imu.update(*m, data);
  if (now_ns >= push_until_ns) mju_zero(data.xfrc_applied + 6 * map.trunk, 6);
}

void RobotBody::Parts::placeAt(const std::array<double, kJoints>& angles_rad, double lean_rad, double settle_s) {
  placeOnFloor(*m, *d, map, angles_rad, lean_rad);
  settleOnFloor(*m, *d, map, settle_s);
  for (std::size_t i = 0; i < kJoints; ++i) servos[i].reset(angles_rad[i]);
  torques.reset(*d, map);
  imu.reset(*d);
  pending_ns = push_until_ns = 0;
  next_firmware_ns = now_ns;
  publish();
}

void RobotBody::Parts::publish() noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) state.joint[i] = servos[i].report();
  state.gyro_rad_s = imu.gyro(*d, samples);
  state.accel_m_s2 = imu.accelerometer(*m, *d, samples);
}

RobotBody::RobotBody(const Model& model, const RobotBodyOptions& options) {
  parts_ = std::make_unique<Parts>(model, options);
  parts_->placeAt(startPose(), kStartLeanRad, kSettleSeconds);
  parts_->checkWarnings();
  if (error() != nullptr) throw std::runtime_error{model.body.xml + ": " + error()};
}

RobotBody::~RobotBody() = default;

void RobotBody::step(Nanos dt, const Drives& drives) noexcept {
  Parts& p = *parts_;
  if (error() != nullptr) return;
  p.pending_ns += dt.count();
  MujocoGuard guard;
  const bool done = guard.attempt([&] {
    for (; p.pending_ns >= p.step_ns; p.pending_ns -= p.step_ns) p.physicsStep(drives);
  });
  if (done)
    p.checkWarnings();
  else
    p.stopSimulation(guard.why());
  if (error() == nullptr) p.publish();
}

const char* RobotBody::error() const noexcept {
  return parts_->error[0] == '\0' ? nullptr : parts_->error.data();
}

const BodyState& RobotBody::state() const noexcept {
  return parts_->state;
}

void RobotBody::place(const std::array<double, kJoints>& angles_rad, double lean_rad) {
  parts_->placeAt(angles_rad, lean_rad);
}

void RobotBody::push(const std::array<double, 3>& force_n, Nanos duration) noexcept {
  Parts& p = *parts_;
  mju_copy3(p.d->xfrc_applied + 6 * p.map.trunk, force_n.data());
  p.push_until_ns = p.now_ns + duration.count();
}

void RobotBody::placeBall(double x_m, double y_m) noexcept {
  Parts& p = *parts_;
  if (p.map.ball_qpos < 0) return;
  mjtNum* q = p.d->qpos + p.map.ball_qpos;
  const mjtNum* at_start = p.m->qpos0 + p.map.ball_qpos;
  mju_copy(q, at_start, 7);  // height and orientation
  q[0] = x_m;
  q[1] = y_m;
  mju_zero(p.d->qvel + p.map.ball_dof, 6);
}

void RobotBody::press(std::uint8_t buttons) noexcept {
  parts_->state.buttons = buttons;
}

std::array<double, 3> RobotBody::trunkPosition() const noexcept {
  const mjtNum* q = parts_->d->qpos + parts_->map.trunk_qpos;
  return {q[0], q[1], q[2]};
}

double RobotBody::upright() const noexcept {
  const mjtNum up[3] = {0, 1, 0};  // of the trunk
  mjtNum world[3];
  mju_rotVecQuat(world, up, parts_->d->qpos + parts_->map.trunk_qpos + 3);
  return world[2];
}

double RobotBody::heading() const noexcept {
  const mjtNum forward[3] = {0, 0, 1};  // of the trunk
  mjtNum world[3];
  mju_rotVecQuat(world, forward, parts_->d->qpos + parts_->map.trunk_qpos + 3);
  return std::atan2(world[1], world[0]);
}

double RobotBody::time_s() const noexcept {
  return static_cast<double>(parts_->now_ns) * 1e-9;
}

const mjModel_* RobotBody::mujocoModel() const noexcept {
  return parts_->m.get();
}

mjData_* RobotBody::mujocoData() noexcept {
  return parts_->d.get();
}

}  // namespace darwinop::twin
