// Robot simulation step: servos, physics, sensors.
#include "twin/body/robot_body_parts.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "twin/body/ball.hpp"
#include "twin/body/placing.hpp"

namespace darwinop::twin {
namespace {

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

RobotBody::Parts::Parts(const Model& requested, const RobotBodyOptions& options)
    : servos{servosOf(requested)},
      model{withStepFor(requested, servos)},
      m{loadBody(model, options.ball != Ball::kNone)},
      map{mapBody(*m, model.body.xml)},
      torques{*m, map, servos, model.body.hold_until_driven},
      d{dataFor(*m, model.body.xml)},
      imu{*m, map, model.imu, options.seed, model.servo.firmware_period_s},
      clamped_up{options.clamped_up},
      ball_circles{options.ball == Ball::kCircles},
      step_ns{nanosOf(model.body.step_s)},
      firmware_ns{nanosOf(model.servo.firmware_period_s)} {
  if (clamped_up) clampTrunk(*m, map);
  if (options.ball_colour) paintBall(*m, *options.ball_colour);
}

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

// A bridge draws the winding's current for the share of its duty. With the duties of the last cycle the current falls
// with the voltage, which is solved for: the drop of the last cycle alone would oscillate at full load.
void RobotBody::Parts::sagBattery() noexcept {
  double drawn_a = 0, falls_a_v = 0;
  for (const Servo& servo : servos) {
    const Signals& s = servo.signals();
    if (!s.torque_on) continue;
    drawn_a += s.duty * s.current_a;
    falls_a_v += s.duty * s.duty / s.resistance_ohm;
  }
  const double ohm = model.body.battery_resistance_ohm;
  battery_drop_v = ohm * (drawn_a + falls_a_v * battery_drop_v) / (1 + ohm * falls_a_v);
}

void RobotBody::Parts::physicsStep(const Drives& drives) noexcept {
  mjData& data = *d;
  for (; next_firmware_ns <= now_ns; next_firmware_ns += firmware_ns) {
    if (model.body.battery_resistance_ohm > 0) sagBattery();
    for (std::size_t i = 0; i < kJoints; ++i) {
      ServoDrive drive = drives[i];
      drive.supply_v = std::max(drive.supply_v - battery_drop_v, 0.0);  // in this order, NaN (unknown) stays NaN
      servos[i].firmware(drive, torques.encoderRad(servos[i], i, data.qpos[map.qpos[i]]), data.qvel[map.dof[i]]);
    }
  }
  if (ball_circles) moveBallOnCircle(data, map, static_cast<double>(now_ns) * 1e-9);
  torques.step(*m, data, map, servos);
  if (clamped_up) holdInStand(data, map, *clamped_up);
  now_ns += step_ns;
  ++samples;
  imu.update(*m, data);
  if (now_ns >= push_until_ns) mju_zero(data.xfrc_applied + 6 * map.trunk, 6);
}

void RobotBody::Parts::placeAt(const std::array<double, kJoints>& angles_rad, double lean_rad, double settle_s) {
  if (clamped_up) {
    placeInStand(*m, *d, map, angles_rad, *clamped_up);
  } else {
    placeOnFloor(*m, *d, map, angles_rad, lean_rad);
    settleOnFloor(*m, *d, map, settle_s);
  }
  for (std::size_t i = 0; i < kJoints; ++i) servos[i].reset(angles_rad[i]);
  torques.reset(*d, map);
  imu.reset(*m, *d);
  battery_drop_v = 0;
  pending_ns = push_until_ns = 0;
  next_firmware_ns = now_ns;
  publish();
}

bool RobotBody::Parts::clampAt(const ClampedUp& up) noexcept {
  try {
    if (!clamped_up) clampTrunk(*m, map);
  } catch (const std::exception&) {
    return false;  // MuJoCo refused the changed model
  }
  clamped_up = up;
  holdInStand(*d, map, up);
  mj_kinematics(m.get(), d.get());
  imu.reset(*m, *d);
  publish();
  return true;
}

void RobotBody::Parts::publish() noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) state.joint[i] = servos[i].report();
  state.gyro_rad_s = imu.gyro(*d, samples);
  state.accel_m_s2 = imu.accelerometer(*m, *d, samples);
  state.battery_drop_v = battery_drop_v;
  mju_copy3(state.trunk_m.data(), d->qpos + map.trunk_qpos);
}

}  // namespace darwinop::twin
