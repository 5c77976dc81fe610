// The single-joint bench: a servo on a stand swings an arm with a weight. No MuJoCo, no I/O, as fast as possible.
#pragma once

#include <memory>
#include <vector>

#include "twin/bench/near_sine.hpp"
#include "twin/servo/servo.hpp"
#include "twin/servo/shaft.hpp"
#include "twin/servo/transmission.hpp"

namespace darwinop::twin {

/// A weight at the end of a uniform arm; angle 0 hangs straight down, positive counter-clockwise.
struct Pendulum {
  double payload_kg = 0.1, arm_mass_kg = 0, length_m = 0.1;
  double gravity_m_s2 = 9.80665;
};

struct BenchOptions {
  int steps_per_period = 2;  // mechanical steps in a firmware period; a soft gear takes more by itself, and of
                             // two or more the first is as long as the jump of a motor of law speed_p
  double start_rad = 0;      // at rest there
  double start_rad_s = 0;
  double session_time_s = 0;
};

/// One servo, one pendulum:
///
///   J q'' = servo - (m L + m_a L/2) g sin q - friction,   J = m L^2 + m_a L^2/3 + armature
///
/// with what the effects change of the load. Second order in the step: position at the middle, torques there, velocity
/// by Shaft. Not thread-safe; step() allocates nothing.
class Bench {
 public:
  /// Throws std::runtime_error for a pendulum that cannot be: a negative mass, no inertia at all.
  Bench(const ServoParameters& parameters, std::vector<std::unique_ptr<Effect>> effects, const Pendulum& pendulum);

  /// From rest, or from the given speed, all history forgotten. Throws std::runtime_error for no steps at all.
  void reset(const BenchOptions& options);
  /// One firmware period.
  void step(const ServoDrive& drive) noexcept;

  [[nodiscard]] double time_s() const noexcept { return servo_.signals().time_s; }
  [[nodiscard]] double position_rad() const noexcept { return position_; }  // of the arm
  [[nodiscard]] double velocity_rad_s() const noexcept { return velocity_; }
  /// What an encoder without error would say; with a soft gear it does not see all of the arm.
  [[nodiscard]] double encoder_rad() const noexcept;
  /// Kinetic energy of arm and rotor, that of a bent gear, and potential energy against hanging down, J.
  [[nodiscard]] double energy_j() const noexcept;
  /// Of arm and rotor, kg m2.
  [[nodiscard]] double inertia_kgm2() const noexcept { return arm_kgm2_ + rotor_kgm2_; }
  /// Torque of gravity when the arm stands out sideways, N m.
  [[nodiscard]] double weight_nm() const noexcept { return weight_nm_; }
  [[nodiscard]] const Servo& servo() const noexcept { return servo_; }

 private:
  [[nodiscard]] double gravityAt(double position_rad) noexcept;
  void stepRigid(int steps) noexcept;
  void stepShaft(double h) noexcept;
  double jumpTime(double period) noexcept;
  void stepSoft(int steps) noexcept;

  Servo servo_;
  Shaft shaft_;
  Transmission transmission_;
  NearSine sine_;
  double arm_kgm2_ = 0, rotor_kgm2_ = 0, weight_nm_ = 0, hangs_at_rad_ = 0;
  int steps_ = 2;
  double position_ = 0, velocity_ = 0;
  double gained_ = 0;  // of the velocity, by the last step
};

}  // namespace darwinop::twin
