#include "gap/identify/body/battery.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/registers.hpp"
#include "core/text/formatted.hpp"
#include "gap/identify/body/floor_effect.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// A, that a joint draws from the battery at a row: the winding's current for the share of the duty. NaN: not known.
double drawnBy(const BodyCase& given, const Trajectory& joint, std::size_t row, double supply_v) {
  if (joint.torque_on[row == 0 ? 0 : row - 1] == 0) return 0;
  if (row == 0 || row + 1 >= joint.rows()) return std::numeric_limits<double>::quiet_NaN();
  const twin::ServoParameters& servo = given.joints.model.servo;
  const double speed =
      (joint.position_rad[row + 1] - joint.position_rad[row - 1]) / (joint.time_s[row + 1] - joint.time_s[row - 1]);
  const double duty = joint.load[row];
  return duty * (duty * supply_v - servo.back_emf_vs_rad * speed) / servo.resistance_ohm;
}

struct Point {
  double drawn_a, sag_v;
};

std::vector<Point> pointsOf(const BodyCase& given) {
  std::vector<Point> out;
  for (std::size_t log = 0; log < given.logs.size(); ++log) {
    const BodyLog& of = given.logs[log];
    if (of.held_out) continue;
    for (std::size_t row = 0; row < of.rows() && row < of.board_v.size(); ++row) {
      double drawn = 0;
      for (std::size_t joint = 0; joint < kJoints; ++joint)
        drawn += drawnBy(given, given.joint(log, joint), row, of.board_v[row]);
      const double own_v = given.joints.model.body.battery_resistance_ohm * drawn;  // found is what is beyond it
      const Point point{drawn, of.battery_v - of.board_v[row] - own_v};
      if (std::isfinite(point.drawn_a) && std::isfinite(point.sag_v)) out.push_back(point);
    }
  }
  return out;
}

}  // namespace

std::optional<FoundBattery> identifyBattery(const BodyCase& given) {
  if (given.joints.model.servo.law != twin::Law::kVoltageP) return {};
  const std::vector<Point> points = pointsOf(given);
  const auto n = static_cast<double>(points.size());
  // A battery that has another voltage than the case says is not a resistance.
  double mean_a = 0, mean_v = 0, aa = 0, av = 0, vv = 0;
  for (const Point& point : points) mean_a += point.drawn_a / n, mean_v += point.sag_v / n;
  for (const Point& point : points) {
    const double a = point.drawn_a - mean_a, v = point.sag_v - mean_v;
    aa += a * a, av += a * v, vv += v * v;
  }
  if (!(aa > 0)) return {};
  FoundBattery found{.resistance_ohm = av / aa};
  const double left = vv - found.resistance_ohm * av;
  found.remains_v = std::sqrt(left / n);
  constexpr double kStep = find(kCm730, "voltage").scale;
  const double noise = std::max({found.remains_v, thresholds::kSupplyNoise, kStep / std::sqrt(12.0)});
  found.sigma_ohm = noise / std::sqrt(aa / thresholds::kCorrelatedSamples);
  for (const Point& point : points) found.sag_v = std::max(found.sag_v, found.resistance_ohm * point.drawn_a);
  const double gain = std::pow(found.resistance_ohm / found.sigma_ohm, 2);
  const auto names = static_cast<double>(floorEffects(given.joints.model).size());
  const double price = std::log(n / thresholds::kCorrelatedSamples) + 2 * std::log(names);
  if (found.resistance_ohm <= 0 || gain - price < -2 * std::log(thresholds::kMechanicalChance)) return {};
  return found;
}

std::string asText(const FoundBattery& found) {
  return text::formatted("  battery_resistance at battery, resistance %.4g +-%.2g ohm, up to %.2f V\n",
                         found.resistance_ohm, thresholds::kInterval90 * found.sigma_ohm, found.sag_v);
}

nlohmann::ordered_json effectJson(const FoundBattery& found) {
  const double half = thresholds::kInterval90 * found.sigma_ohm;
  return {{"id", kBatteryResistance},
          {"at", "battery"},
          {"params", {{"resistance", found.resistance_ohm}}},
          {"interval_90", {{"resistance", {found.resistance_ohm - half, found.resistance_ohm + half}}}}};
}

}  // namespace darwinop::gap
