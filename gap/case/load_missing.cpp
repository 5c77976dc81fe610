// Detects a load that the servo or its driver does not report: a column of zeros, while the control law asks for duty.
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kAsked = 0.1;       // of full duty: no punch is larger
constexpr double kError = 0.05;      // rad: no dead band is wider
constexpr std::size_t kEnough = 20;  // rows; after a step of the goal the duty may come a few rows late

}  // namespace

void dropMissingLoad(Trajectory& log, const std::string& file, Case& of) {
  const twin::ServoParameters& servo = of.model.servo;
  if (servo.law != twin::Law::kVoltageP) return;
  if (std::ranges::any_of(log.load, [](double load) { return !std::isnan(load) && load != 0; })) return;
  std::size_t asked = 0;
  for (std::size_t row = 1; row < log.rows(); ++row) {
    if (log.torque_on[row] == 0 || std::isnan(log.load[row])) continue;
    const double error = std::abs(log.goal_rad[row - 1] - log.position_rad[row]);
    if (error > kError && servo.duty_per_kp_per_rad * log.p_register * error > kAsked) ++asked;
  }
  if (asked < kEnough) return;
  std::ranges::fill(log.load, std::numeric_limits<double>::quiet_NaN());
  of.warnings.push_back(file + ": " + messages::kLoadIsZero + messages::kNotMeasured);
}

}  // namespace darwinop::gap
