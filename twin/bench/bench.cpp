// Single-joint bench: integrates one servo model and a pendulum, rigid or through an elastic transmission.
#include "twin/bench/bench.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace darwinop::twin {
namespace {

constexpr double kMinJump = 1.0 / 64;  // firmware periods
constexpr double kMinTorque = 1e-3;    // N m; avoids a division by 0 when the motor cannot lift its load

void check(double value, double low, const char* what) {
  if (std::isfinite(value) && value >= low) return;
  throw std::runtime_error("pendulum: " + std::string{what} + " is " + std::to_string(value) +
                           "; must be a finite number of at least 0");
}

}  // namespace

Bench::Bench(const ServoParameters& parameters, std::vector<std::unique_ptr<Effect>> effects, const Pendulum& pendulum)
    : servo_{parameters, std::move(effects)} {
  check(pendulum.payload_kg, 0, "payload (kg)");
  check(pendulum.arm_mass_kg, 0, "mass of the arm (kg)");
  check(pendulum.length_m, 0, "length (m)");
  check(pendulum.gravity_m_s2, 0, "gravity (m/s2)");
  const LoadChange& change = servo_.load();
  const double m = pendulum.payload_kg * change.mass_scale, arm = pendulum.arm_mass_kg * change.mass_scale;
  // A negative shift moves the mass no further than to the axis.
  const double payload_m = std::max(0.0, pendulum.length_m + change.com_shift_m);
  const double arm_com_m = std::max(0.0, pendulum.length_m / 2 + change.com_shift_m);
  arm_kgm2_ = m * payload_m * payload_m + arm * (pendulum.length_m * pendulum.length_m / 12 + arm_com_m * arm_com_m);
  weight_nm_ = (m * payload_m + arm * arm_com_m) * pendulum.gravity_m_s2;
  equilibrium_rad_ = change.angle_offset_rad;
  rotor_kgm2_ = parameters.armature_kgm2 + change.armature_kgm2;
  if (!(inertia_kgm2() > 0)) throw std::runtime_error(std::string{"pendulum: "} + kNoInertia);
  reset({});
}

void Bench::reset(const BenchOptions& options) {
  if (options.steps_per_period < 1)
    throw std::runtime_error("bench: " + std::to_string(options.steps_per_period) + " " + kTooFewSteps);
  servo_.reset(options.start_rad, options.goal_rad.value_or(options.start_rad), options.session_time_s);
  position_ = options.start_rad;
  velocity_ = options.start_rad_s;
  last_velocity_change_ = 0;
  sine_ = {};
  transmission_.reset(position_, velocity_, rotor_kgm2_);
  steps_ = options.steps_per_period;
  if (options.is_settled && servo_.softGear()) restInGears();
}

/// The weight at an angle bends the gears, which changes the angle: a spring that holds an arm changes it by less and
/// less.
void Bench::restInGears() noexcept {
  constexpr int kMostRounds = 50;
  const double reading = position_;
  for (int round = 0; round < kMostRounds; ++round)
    position_ = transmission_.rest(servo_.signals(), reading, -gravityAt(position_), rotor_kgm2_);
}

void Bench::step(const ServoDrive& drive) noexcept {
  if (!servo_.softGear()) {
    servo_.firmware(drive, position_, velocity_);
    stepRigid(steps_);
    return;
  }
  const Signals& s = servo_.signals();
  servo_.firmware(drive, transmission_.encoderRad(s, position_), transmission_.gearVelocity());
  stepSoft(std::max(steps_, transmission_.stepsFor(s, arm_kgm2_, servo_.parameters().firmware_period_s)));
}

void Bench::stepRigid(int steps) noexcept {
  const double period = servo_.parameters().firmware_period_s;
  const double first = steps > 1 ? jumpTime(period) : 0;
  if (first > 0) {
    stepShaft(first);
    last_velocity_change_ = 0;  // the jump does not continue in the next step
    --steps;
  }
  if (first == period) return;
  for (int i = 0; i < steps; ++i) stepShaft((period - first) / steps);
}

// Law speed_p: time in which the motor reaches its commanded speed at full torque; one mechanical step has this length.
// 0 for the other law and with torque off.
double Bench::jumpTime(double period) noexcept {
  const Signals& s = servo_.signals();
  if (s.law != Law::kSpeedP || !s.torque_on) return 0;
  const double change = s.speed_command_rad_s - velocity_;
  const double torque = std::min(servo_.parameters().torque_max_nm * s.duty_limit, s.torque_limit_nm);
  const double net = torque + std::copysign(1.0, change) * gravityAt(position_);
  return std::clamp(inertia_kgm2() * std::abs(change) / std::max(net, kMinTorque), kMinJump * period, period);
}

void Bench::stepShaft(double h) noexcept {
  position_ += velocity_ * h / 2;
  const double gravity = gravityAt(position_), before = velocity_;
  // Friction depends on the mid-step speed, extrapolated from the last change.
  const double speed = velocity_ == 0 ? 0 : velocity_ + last_velocity_change_ / 2;
  const Actuation actuation = servo_.actuate(position_, speed, gravity);
  velocity_ = shaft_.kick(velocity_, actuation, gravity, inertia_kgm2(), h);
  last_velocity_change_ = velocity_ - before;
  if (actuation.follows_speed) servo_.noteMotorTorque(shaft_.motorTorque());
  position_ += velocity_ * h / 2;
}

void Bench::stepSoft(int steps) noexcept {
  const double h = servo_.parameters().firmware_period_s / steps, arm_kgm2 = transmission_.armInertia(arm_kgm2_);
  for (int i = 0; i < steps; ++i) {
    // Midpoint rule for gear side and arm.
    const double middle = position_ + velocity_ * h / 2, gravity = gravityAt(middle);
    const double gear = transmission_.step(servo_, {position_, velocity_, arm_kgm2, gravity}, h);
    velocity_ += (gravity + gear) / arm_kgm2 * h;
    position_ = middle + velocity_ * h / 2;
  }
}

double Bench::encoder_rad() const noexcept {
  return servo_.softGear() ? transmission_.encoderRad(servo_.signals(), position_) : position_;
}

double Bench::gravityAt(double position_rad) noexcept {
  return -weight_nm_ * sine_(position_rad - equilibrium_rad_);
}

double Bench::energy_j() const noexcept {
  const double height = weight_nm_ * (1 - std::cos(position_ - equilibrium_rad_));
  const double arm = arm_kgm2_ * velocity_ * velocity_ / 2 + height;
  if (servo_.softGear()) return arm + transmission_.energy_j(servo_.signals(), position_);
  return arm + rotor_kgm2_ * velocity_ * velocity_ / 2;
}

}  // namespace darwinop::twin
