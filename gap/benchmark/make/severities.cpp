#include "gap/benchmark/make/severities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "gap/parallel/parallel.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {
namespace {

constexpr double kDecades = 3.5;      // from the greatest value that is tried to the smallest
constexpr double kMostOfRange = 0.9;  // of the plausible range: at its end a fit cannot tell what is beyond
constexpr int kTries = 14;
constexpr double kBeyondPrior = 3;   // sigma
constexpr double kNearEnough = 0.1;  // of the gap that is wanted

/// The line along which an effect grows.
struct Way {
  std::vector<double> values;  // of the parameters that stay
  std::optional<std::size_t> grows;
  double from = 0, to = 0;
  bool geometric = false;           // between two values that both are far from 0
  std::optional<std::size_t> tied;  // grows along, by this ratio
  double ratio = 0;

  /// From hardly anything to 1, close to the end of the plausible range.
  [[nodiscard]] std::vector<double> at(double strength) const {
    std::vector<double> out = values;
    if (!grows) return out;
    strength = std::min(strength, geometric ? kMostOfRange : 1 + std::log10(kMostOfRange) / kDecades);
    out[*grows] =
        geometric ? from * std::pow(to / from, strength) : from + (to - from) * std::pow(10, kDecades * (strength - 1));
    if (tied) out[*tied] = out[*grows] * ratio;
    return out;
  }
};

void drawTheRest(const twin::EffectInfo& effect, Rng& rng, Way& way) {
  using Growth = twin::Synthetic::Growth;
  switch (effect.synthetic.growth) {
    case Growth::kFirst:
      break;
    case Growth::kFirstAndSecond:
      way.tied = 1;
      way.ratio = rng.between(0.2, 0.8);
      break;
    case Growth::kFirstOrSecond:
      way.grows = rng.below(2);
      break;
    case Growth::kSwitch:
      way.grows.reset();
      way.values[0] = effect.parameters[0].typical;
      break;
  }
  for (const twin::DrawnParameter& drawn : effect.synthetic.drawn)
    way.values[drawn.parameter] = drawn.choices.empty() ? rng.between(drawn.low, drawn.high) : rng.pick(drawn.choices);
}

Way drawnWay(const Hypothesis& without, const twin::EffectInfo& effect, Rng& rng) {
  Way way;
  for (const twin::Parameter& parameter : effect.parameters) way.values.push_back(parameter.neutral);
  if (const twin::EffectSetting* const there = without.find(effect.id)) way.values = there->values;
  way.grows = 0;
  drawTheRest(effect, rng, way);
  if (!way.grows) return way;
  const twin::Parameter& parameter = effect.parameters[*way.grows];
  way.from = way.values[*way.grows];
  const bool down = parameter.low<parameter.neutral, up = parameter.high> parameter.neutral;
  const bool goes_up = up && (!down || rng.coin());
  way.to = goes_up ? parameter.high : parameter.low;
  way.geometric = parameter.logarithmic && parameter.neutral > 0;
  return way;
}

}  // namespace

GapRange gapRangeOf(int severity) {
  switch (severity) {
    case 1:
      return {2 * kFloor, 4 * kFloor};
    case 2:
      return {10 * kFloor, 30 * kFloor};
    case 3:
      return {40 * kFloor, 80 * kFloor};
    default:
      throw std::invalid_argument("severity " + std::to_string(severity) + " does not exist; 1, 2 and 3 do");
  }
}

int severityOfGap(double gap_rad) {
  // Between the ranges, and below what is seen at all.
  constexpr std::array kBegins{1.3 * kFloor, 6.5 * kFloor, 35 * kFloor};
  return static_cast<int>(std::ranges::count_if(kBegins, [=](double begin) { return gap_rad >= begin; }));
}

double gapBetween(const Case& given, const Hypothesis& a, const Hypothesis& b) {
  std::vector<double> sums(given.logs.size());
  forEach(given.logs.size(), [&](std::size_t i) {
    const Trajectory& log = given.logs[i];
    if (log.held_out || log.repeat_of) return;
    Trace first, second;
    rollOut(given, i, a, {}, first);
    rollOut(given, i, b, {}, second);
    for (std::size_t row = 0; row < log.rows(); ++row)
      sums[i] += std::pow(first[kPositionSignal][row] - second[kPositionSignal][row], 2);
  });
  double sum = 0, rows = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sum += sums[i];
    if (!given.logs[i].held_out && !given.logs[i].repeat_of) rows += static_cast<double>(given.logs[i].rows());
  }
  return rows > 0 ? std::sqrt(sum / rows) : 0;
}

Strength strengthOf(const Case& given, const Hypothesis& without, const twin::EffectInfo& effect, int severity,
                    Rng& rng) {
  const GapRange range = gapRangeOf(severity);
  const double wanted = range.low_rad * std::pow(range.high_rad / range.low_rad, rng.uniform());
  const Way way = drawnWay(without, effect, rng);
  const auto tried = [&](double strength) {
    Strength found{.severity = severity, .values = way.at(strength), .gap_rad = 0};
    Hypothesis with = without;
    with.with(effect).values = found.values;
    found.gap_rad = gapBetween(given, without, with);
    return found;
  };
  // What a prior lets a number do is nothing hidden.
  const auto shows = [&](const Strength& found) {
    Hypothesis with = without;
    with.with(effect).values = found.values;
    return priorSigmasMoved(given, baselineOf(given), with, effect) > kBeyondPrior;
  };
  const auto enough = [&](const Strength& found) {
    return std::abs(found.gap_rad / wanted - 1) < kNearEnough && shows(found);
  };
  Strength found = tried(1);
  if (!way.grows || found.gap_rad < wanted) {
    found.severity = std::min(way.grows ? severity : 3, severityOfGap(found.gap_rad));
    return found;
  }
  double weak = 0, strong = 1;
  for (int i = 0; i < kTries && !enough(found); ++i) {
    const double middle = (weak + strong) / 2;
    found = tried(middle);
    (found.gap_rad < wanted || !shows(found) ? weak : strong) = middle;
  }
  if (!enough(found)) {  // it jumps, or has to leave its prior
    if (!shows(found)) found = tried(strong);
    found.severity = shows(found) ? severityOfGap(found.gap_rad) : 0;
  }
  return found;
}

}  // namespace darwinop::gap
