// Single-joint bench: simulates one servo with a pendulum, without MuJoCo and without I/O.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/units.hpp"
#include "twin/bench/near_sine.hpp"
#include "twin/servo/servo.hpp"
#include "twin/servo/shaft.hpp"
#include "twin/servo/transmission.hpp"

namespace darwinop::twin {

/// Point mass at the end of a uniform arm. Angle 0 hangs straight down, positive counter-clockwise.
struct Pendulum {
  double payload_kg = 0.1, arm_mass_kg = 0, length_m = 0.1;
  double gravity_m_s2 = kGravity;
};

// Errors of Bench.
inline constexpr const char* kNoInertia = "the total inertia is 0; set a payload or an armature";
inline constexpr const char* kTooFewSteps = "mechanical steps per firmware period; must be at least 1";

struct BenchOptions {
  int steps_per_period = 2;  // mechanical steps per firmware period, at least 1. An elastic transmission uses more
                             // where it needs them. Law speed_p with two or more: the first step is as long as the
                             // motor takes to reach its speed
  double start_rad = 0;
  double start_rad_s = 0;
  std::optional<double> goal_rad = {};  // where the servo's goal has been; none: start_rad
  double session_time_s = 0;
  // The arm has come to rest in its gears: play and spring are as far apart as its weight takes them, and the encoder
  // reads start_rad. Without it they begin at the same angle, and a heavy arm swings on a spring.
  bool is_settled = false;
};

/// One servo, one pendulum:
///
///   J q'' = servo - (m L + m_a L/2) g sin q - friction,   J = m L^2 + m_a L^2/3 + armature
///
/// plus the load changes of the effects. Second order in the step: torques at the mid-step position, velocity by Shaft.
/// Not thread-safe; step() allocates nothing.
class Bench {
 public:
  /// Throws std::runtime_error for a negative or infinite value and for a total inertia of 0.
  Bench(const ServoParameters& parameters, std::vector<std::unique_ptr<Effect>> effects, const Pendulum& pendulum);

  /// Sets the initial state and clears all history. Throws std::runtime_error for fewer than one step per period.
  void reset(const BenchOptions& options);
  /// One firmware period.
  void step(const ServoDrive& drive) noexcept;

  [[nodiscard]] double time_s() const noexcept { return servo_.signals().time_s; }
  [[nodiscard]] double position_rad() const noexcept { return position_; }  // of the arm
  [[nodiscard]] double velocity_rad_s() const noexcept { return velocity_; }
  /// Reading of an ideal encoder. It sits on the horn, so with an elastic transmission it differs from position_rad().
  [[nodiscard]] double encoder_rad() const noexcept;
  /// Kinetic energy of arm and rotor, elastic energy of the transmission, potential energy above the lowest point; J.
  [[nodiscard]] double energy_j() const noexcept;
  /// Of arm and rotor, kg m2.
  [[nodiscard]] double inertia_kgm2() const noexcept { return arm_kgm2_ + rotor_kgm2_; }
  /// Gravity torque with the arm horizontal, N m.
  [[nodiscard]] double weight_nm() const noexcept { return weight_nm_; }
  [[nodiscard]] const Servo& servo() const noexcept { return servo_; }

 private:
  [[nodiscard]] double gravityAt(double position_rad) noexcept;
  void restInGears() noexcept;
  void stepRigid(int steps) noexcept;
  void stepShaft(double h) noexcept;
  double jumpTime(double period) noexcept;
  void stepSoft(int steps) noexcept;

  Servo servo_;
  Shaft shaft_;
  Transmission transmission_;
  NearSine sine_;
  double arm_kgm2_ = 0, rotor_kgm2_ = 0, weight_nm_ = 0, equilibrium_rad_ = 0;
  int steps_ = 2;
  double position_ = 0, velocity_ = 0;
  double last_velocity_change_ = 0;  // rad/s
};

}  // namespace darwinop::twin
