// Detects a load in another unit: ten or a hundred times as large as the duty that the control law asks for.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "gap/case/median.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

// Of full duty: less is within a dead band or a punch, more within a limit.
constexpr double kLeastAsked = 0.05, kMostAsked = 0.5;
constexpr std::size_t kEnoughRows = 50;
// Gains are off by 2 (an XL330 of a manual), limits of duty by 4; units by 10 or more.
constexpr double kOtherScale = 6;

}  // namespace

void dropOddLoad(Trajectory& log, const std::string& file, Case& of) {
  const twin::ServoParameters& servo = of.model.servo;
  if (servo.law != twin::Law::kVoltageP) return;
  std::vector<double> ratios;
  for (std::size_t row = 1; row < log.rows(); ++row) {
    if (log.torque_on[row] == 0 || std::isnan(log.load[row])) continue;
    const double error = std::abs(log.goal_rad[row - 1] - log.position_rad[row]);
    const double asked = servo.duty_per_kp_per_rad * log.p_register * error;
    if (asked >= kLeastAsked && asked <= kMostAsked) ratios.push_back(std::abs(log.load[row]) / asked);
  }
  if (ratios.size() < kEnoughRows) return;
  const double ratio = medianOf(ratios);
  if (ratio == 0) return;  // a dead band, or dropMissingLoad()
  if (ratio >= 1 / kOtherScale && ratio <= kOtherScale) return;
  std::ranges::fill(log.load, std::numeric_limits<double>::quiet_NaN());
  char times[32];
  std::snprintf(times, sizeof times, "%.2g", ratio);
  of.warnings.push_back(file + ": load is " + times + messages::kLoadHasOtherScale);
}

}  // namespace darwinop::gap
