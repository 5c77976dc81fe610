#include "twin/body/robot_body.hpp"

#include <mujoco/mujoco.h>

#include <cmath>
#include <stdexcept>

#include "twin/body/mujoco_guard.hpp"
#include "twin/body/placing.hpp"
#include "twin/body/robot_body_parts.hpp"

namespace darwinop::twin {
namespace {

// The start pose kneels on soles and shins; the soles are level at this pitch of the trunk.
constexpr double kStartLeanRad = 0.13;
// Left and right ankle differ by 1.1 degrees in the start pose, so the robot rolls slightly before it is at rest.
constexpr double kSettleSeconds = 0.5;

}  // namespace

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

bool RobotBody::clamp(const std::array<double, 3>& up) noexcept {
  return parts_->clampAt(up);
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
