#include "gap/case/rest_angle.hpp"

#include <algorithm>
#include <cmath>

#include "core/sensors.hpp"
#include "core/units.hpp"
#include "gap/case/median.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr double kRestTime = 0.2;     // s at the end of a stretch, and
constexpr double kRestSpread = 0.02;  // rad: some steps of an encoder
constexpr double kFall = 0.1;         // rad: else friction may hold it where it was released
constexpr double kLeastRest = 0.3;    // rad
constexpr double kMoreFriction = 3;   // than the model's

/// Least and greatest position of rows from `from` to `to`; NaN does not count.
std::pair<double, double> rangeOf(const Trajectory& log, std::size_t from, std::size_t to) {
  std::pair<double, double> out{kUnknown, kUnknown};
  for (std::size_t row = from; row < to; ++row) {
    out.first = std::fmin(out.first, log.position_rad[row]);
    out.second = std::fmax(out.second, log.position_rad[row]);
  }
  return out;
}

}  // namespace

double restAngle(const Trajectory& log) {
  std::vector<double> rests;
  for (std::size_t from = 0, to = 0; from < log.rows(); from = std::max(to, from + 1)) {
    for (to = from; to < log.rows() && log.torque_on[to] == 0;) ++to;
    if (to == from) continue;
    std::size_t still = to;
    while (still > from && log.time_s[to - 1] - log.time_s[still - 1] <= kRestTime) --still;
    const auto [low, high] = rangeOf(log, still, to);
    const auto [lowest, highest] = rangeOf(log, from, to);
    if (still > from && high - low < kRestSpread && highest - lowest > kFall) rests.push_back((low + high) / 2);
  }
  return std::remainder(medianOf(std::move(rests)), 2 * kPi);
}

double farthestRest(const Case& c, const Trajectory& log) {
  const double weight_nm =
      c.pendulum.gravity_m_s2 * c.pendulum.length_m * (log.payload_kg + c.pendulum.arm_mass_kg / 2);
  double friction_nm = 0;
  for (const twin::EffectSetting& effect : c.model.effects)
    if (effect.info == twin::effectWith(twin::ParameterRole::kDryFriction)) friction_nm = effect.values.front();
  return std::max(kLeastRest, kMoreFriction * friction_nm / weight_nm);
}

}  // namespace darwinop::gap
