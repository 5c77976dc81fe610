#include "gap/identify/body/battery.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/registers.hpp"
#include "core/sensors.hpp"
#include "core/text/formatted.hpp"
#include "core/units.hpp"
#include "gap/case/body/row_law.hpp"
#include "gap/identify/body/floor_effect.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// A, that a joint draws from the battery when the board of this row is read: the winding's current for the share of
/// the duty. NaN: not known.
double drawnBy(const BodyCase& given, const Trajectory& joint, std::size_t row, double supply_v) {
  if (row == 0 || row + 1 >= joint.rows()) return kUnknown;
  if (joint.torque_on[row - 1] == 0) return 0;
  const twin::ServoParameters& servo = given.joints.model.servo;
  const double speed =
      (joint.position_rad[row + 1] - joint.position_rad[row - 1]) / (joint.time_s[row + 1] - joint.time_s[row - 1]);
  // The runtime reads the board first: no servo acts yet on the row's goals, whose step the later load answers.
  const double duty = joint.isReadAfterWrite()
                          ? lawOf(given, joint, row - 1, joint.position_rad[row] - speed * joint.read_s[row])
                          : joint.load[row];
  return duty * (duty * supply_v - servo.back_emf_vs_rad * speed) / servo.resistance_ohm;
}

constexpr double kStep = find(kCm730, "voltage").scale;  // V, of the board's register

/// `sag_v`: as read, half a step more or less.
struct Point {
  double drawn_a, sag_v;
};

using PointSets = std::vector<std::vector<Point>>;

/// Of logs that are held out, or of the others: a set for each voltage of the battery that the case says.
PointSets pointsOf(const BodyCase& given, bool held_out) {
  std::map<double, std::vector<Point>> by_battery;
  for (std::size_t log = 0; log < given.logs.size(); ++log) {
    const BodyLog& of = given.logs[log];
    if (of.held_out != held_out) continue;
    std::vector<Point>& points = by_battery[of.battery_v];
    for (std::size_t row = 0; row < of.rows() && row < of.board_v.size(); ++row) {
      double drawn = 0;
      for (std::size_t joint = 0; joint < kJoints; ++joint)
        drawn += drawnBy(given, given.joint(log, joint), row, of.board_v[row]);
      const double own_v = given.joints.model.body.battery_resistance_ohm * drawn;  // found is what is beyond it
      const Point point{drawn, of.battery_v - of.board_v[row] - own_v};
      if (std::isfinite(point.drawn_a) && std::isfinite(point.sag_v)) points.push_back(point);
    }
  }
  PointSets out;
  for (auto& [battery_v, points] : by_battery) out.push_back(std::move(points));
  return out;
}

double densityAt(double z) {
  return std::exp(-z * z / 2) / std::sqrt(2 * kPi);
}
double shareBelow(double z) {
  return std::erfc(-z / std::numbers::sqrt2) / 2;
}

/// Sag = offset + resistance * current + noise, read in steps: a regression with censored values. A sag of less than a
/// step is often read as none, which bends a line through the readings. A battery that has another voltage than the
/// case says is not a resistance: each voltage that it says has an offset, as a recording's own is that under load.
struct CensoredLine {
  double resistance_ohm = 0, sigma_v = kStep, log_likelihood = 0;

  /// Most probable numbers, by expectation and maximization; of a known resistance, the others.
  static CensoredLine fitted(const PointSets& sets, std::optional<double> known_ohm = {});

 private:
  /// Moments of the sag within the step that was read, from the numbers so far.
  struct Moments {
    double mean, variance;
  };
  Moments within(const Point& point, double offset_v);
};

CensoredLine::Moments CensoredLine::within(const Point& point, double offset_v) {
  const double mean = offset_v + resistance_ohm * point.drawn_a;
  const double low = (point.sag_v - kStep / 2 - mean) / sigma_v, high = (point.sag_v + kStep / 2 - mean) / sigma_v;
  const double share = low > 0 ? shareBelow(-low) - shareBelow(-high) : shareBelow(high) - shareBelow(low);
  constexpr double kLeastShare = 1e-12;  // far off, the sag is at the nearer end of the step
  log_likelihood += std::log(std::max(kLeastShare, share));
  if (share < kLeastShare) return {mean + sigma_v * (low > 0 ? low : high), 0};
  const double by = (densityAt(low) - densityAt(high)) / share;
  const double spread = 1 + (low * densityAt(low) - high * densityAt(high)) / share - by * by;
  return {mean + sigma_v * by, sigma_v * sigma_v * std::max(0.0, spread)};
}

CensoredLine CensoredLine::fitted(const PointSets& sets, std::optional<double> known_ohm) {
  constexpr int kMostSteps = 300;
  constexpr double kSmallGain = 1e-3;  // of the log likelihood
  CensoredLine line;
  line.resistance_ohm = known_ohm.value_or(0);
  std::vector<double> offsets_v(sets.size(), 0.0);
  for (int step = 0; step < kMostSteps; ++step) {
    const double before = line.log_likelihood;
    line.log_likelihood = 0;
    std::vector<double> means_a(sets.size()), means_v(sets.size());
    double n = 0, aa = 0, av = 0, vv = 0, inner = 0;
    for (std::size_t set = 0; set < sets.size(); ++set) {
      const auto rows = static_cast<double>(sets[set].size());
      std::vector<double> sags_v;
      for (const Point& point : sets[set]) {
        const Moments moments = line.within(point, offsets_v[set]);
        sags_v.push_back(moments.mean), inner += moments.variance;
        means_v[set] += moments.mean / rows, means_a[set] += point.drawn_a / rows;
      }
      for (std::size_t i = 0; i < sags_v.size(); ++i) {
        const double a = sets[set][i].drawn_a - means_a[set], v = sags_v[i] - means_v[set];
        aa += a * a, av += a * v, vv += v * v;
      }
      n += rows;
    }
    if (step > 0 && line.log_likelihood - before < kSmallGain) break;
    line.resistance_ohm = known_ohm.value_or(aa > 0 ? av / aa : 0);
    for (std::size_t set = 0; set < sets.size(); ++set)
      offsets_v[set] = means_v[set] - line.resistance_ohm * means_a[set];
    const double left = vv - line.resistance_ohm * (2 * av - line.resistance_ohm * aa);
    line.sigma_v = std::max(thresholds::kSupplyNoise, std::sqrt(std::max(0.0, left + inner) / n));
  }
  return line;
}

/// Twice the log likelihood ratio of a line to another one, for samples that are correlated.
double gainOf(const CensoredLine& with, const CensoredLine& without) {
  return 2 * (with.log_likelihood - without.log_likelihood) / thresholds::kCorrelatedSamples;
}

/// Held-out logs are less likely with this resistance than without, by more than the error of one number explains.
bool isRefuted(const BodyCase& given, double resistance_ohm) {
  const PointSets sets = pointsOf(given, true);
  return gainOf(CensoredLine::fitted(sets, resistance_ohm), CensoredLine::fitted(sets, 0.0)) < -1;
}

}  // namespace

std::optional<FoundBattery> identifyBattery(const BodyCase& given) {
  if (given.joints.model.servo.law != twin::Law::kVoltageP) return {};
  const PointSets sets = pointsOf(given, false);
  double samples = 0;
  for (const std::vector<Point>& set : sets)
    samples += static_cast<double>(set.size()) / thresholds::kCorrelatedSamples;
  if (samples == 0) return {};
  const CensoredLine with = CensoredLine::fitted(sets), without = CensoredLine::fitted(sets, 0.0);
  const double gain = gainOf(with, without);
  const auto names = static_cast<double>(floorEffects(given.joints.model).size());
  const double price = std::log(samples) + 2 * std::log(names);
  if (!(with.resistance_ohm > 0) || !(gain - price > -2 * std::log(thresholds::kMechanicalChance))) return {};
  if (isRefuted(given, with.resistance_ohm)) return {};
  FoundBattery found{.resistance_ohm = with.resistance_ohm,
                     .sigma_ohm = with.resistance_ohm / std::sqrt(gain),  // of a likelihood that is a parabola
                     .remains_v = with.sigma_v};
  for (const std::vector<Point>& set : sets)
    for (const Point& point : set) found.sag_v = std::max(found.sag_v, found.resistance_ohm * point.drawn_a);
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
