// Ranges and times of one log, and their sums.
#include "gap/case/excitation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotSeen = std::numeric_limits<double>::quiet_NaN();
constexpr double kSpeedWindow = 0.07;  // s, of a speed; four rows of 16 ms
constexpr double kFilled = 0.9;        // of the window, by whole rows
constexpr double kSlowMotion = 0.3;    // rad/s; up to here dry friction changes with speed (Stribeck)
constexpr double kTurning = 0.1;       // rad/s; a reversal goes from beyond this to beyond its opposite
constexpr double kPush = 0.02;         // the same for the load
constexpr double kFullLoad = 0.995;    // of the greatest duty

/// Counts changes of sign from beyond a threshold to beyond its opposite.
class Turns {
 public:
  explicit Turns(double beyond) : beyond_{beyond} {}
  void see(double value) {
    if (!(std::abs(value) > beyond_)) return;
    const bool up = value > 0;
    if (known_ && up != up_) ++count_;
    up_ = up;
    known_ = true;
  }
  [[nodiscard]] int count() const { return count_; }

 private:
  double beyond_;
  bool known_ = false, up_ = false;
  int count_ = 0;
};

/// Around each row, over the window.
std::vector<double> speedsOf(const Trajectory& log) {
  std::vector<double> speeds(log.rows());
  std::size_t from = 0, to = 0;
  for (std::size_t i = 0; i < log.rows(); ++i) {
    while (log.time_s[i] - log.time_s[from] > kSpeedWindow / 2) ++from;
    while (to + 1 < log.rows() && log.time_s[to + 1] - log.time_s[i] <= kSpeedWindow / 2) ++to;
    const double dt = log.time_s[to] - log.time_s[from];
    speeds[i] = dt > 0 ? (log.position_rad[to] - log.position_rad[from]) / dt : 0;
  }
  return speeds;
}

}  // namespace

Extent::Extent() : low{kNotSeen}, high{kNotSeen} {}

void Extent::add(double value) {
  if (std::isnan(value)) return;
  low = std::fmin(low, value);
  high = std::fmax(high, value);
}

void Extent::add(const Extent& other) {
  add(other.low);
  add(other.high);
}

bool Extent::known() const {
  return !std::isnan(low);
}

double Extent::width() const {
  return high - low;
}

double Extent::greatest() const {
  return std::max(std::abs(low), std::abs(high));
}

void Excitation::add(const Excitation& other) {
  duration_s += other.duration_s;
  powered_s += other.powered_s;
  limp_s += other.limp_s;
  at_rest_s += other.at_rest_s;
  slow_s += other.slow_s;
  saturated_s += other.saturated_s;
  reversals += other.reversals;
  load_reversals += other.load_reversals;
  position_rad.add(other.position_rad);
  speed_rad_s.add(other.speed_rad_s);
  load.add(other.load);
  volt_v.add(other.volt_v);
  temp_c.add(other.temp_c);
  session_s.add(other.session_s);
  payloads_kg.insert(other.payloads_kg.begin(), other.payloads_kg.end());
  p_registers.insert(other.p_registers.begin(), other.p_registers.end());
}

Excitation excitationOf(const Trajectory& log, const twin::ServoParameters& servo) {
  Excitation out;
  const std::vector<double> speeds = speedsOf(log);
  const double still_rad_s = 1.5 * 2 * kPi / servo.ticks_per_rev / (kSpeedWindow * kFilled);
  Turns motion{kTurning}, push{kPush};
  for (std::size_t i = 0; i < log.rows(); ++i) {
    const double dt = i + 1 < log.rows() ? log.time_s[i + 1] - log.time_s[i] : 0;
    const double speed = std::abs(speeds[i]);
    (log.torque_on[i] != 0 ? out.powered_s : out.limp_s) += dt;
    if (speed <= still_rad_s) out.at_rest_s += dt;
    if (speed > still_rad_s && speed <= kSlowMotion) out.slow_s += dt;
    if (std::abs(log.load[i]) >= kFullLoad * servo.duty_max) out.saturated_s += dt;
    motion.see(speeds[i]);
    if (log.torque_on[i] != 0) push.see(log.load[i]);
    out.speed_rad_s.add(speeds[i]);
    out.position_rad.add(log.position_rad[i]);
    if (log.torque_on[i] != 0) out.load.add(log.load[i]);
    out.volt_v.add(log.volt_v[i]);
    out.temp_c.add(log.temp_c[i]);
  }
  out.duration_s = log.duration_s();
  out.reversals = motion.count();
  out.load_reversals = push.count();
  if (log.is_session_known) {
    out.session_s.add(log.session_start_s);
    out.session_s.add(log.session_start_s + log.duration_s());
  }
  out.payloads_kg.insert(log.payload_kg);
  out.p_registers.insert(log.p_register);
  return out;
}

}  // namespace darwinop::gap
