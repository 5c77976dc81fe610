#include "gap/identify/body/stance_selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

using StanceValues = std::vector<double>;

std::vector<std::size_t> standingLogs(const BodyCase& given, bool held_out) {
  std::vector<std::size_t> logs = floorLogs(given, held_out);
  std::erase_if(logs, [&](std::size_t log) { return given.logs[log].setup != BodySetup::kFloor; });
  return logs;
}

/// With the bias beyond the model's that a clamped trunk shows, whatever its prior.
ImuDeviation withRestingBias(const BodyCase& given, ImuDeviation imu) {
  const std::vector<RestingReading> readings = restingReadings(given, ImuSensor::kGyro);
  if (readings.empty() || !imu.gyro.bias.isZero()) return imu;
  const RestingImu resting{given.joints.model};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto known = std::ranges::count_if(readings, [&](const auto& one) { return one.isKnown(axis); });
    for (const RestingReading& one : readings)
      if (one.isKnown(axis))
        imu.gyro.bias[axis] +=
            (one.mean[axis] - resting.reading(ImuSensor::kGyro, one.up)[axis]) / static_cast<double>(known);
  }
  return imu;
}

/// One effect's numbers, and what they gain against none.
class StanceFit {
 public:
  StanceFit(const StanceGyro& gyro, const ImuDeviation& base, const FloorEffect& effect)
      : gyro_{gyro}, base_{base}, effect_{effect} {}

  [[nodiscard]] ImuDeviation with(const StanceValues& values) const {
    FloorModel model{.robot = {}, .imu = base_};
    effect_.apply(model, values);
    return model.imu;
  }
  [[nodiscard]] double at(const StanceValues& values) const {
    double priors = 0;
    for (std::size_t i = 0; i < values.size(); ++i) priors += std::pow(effect_.numbers[i].priorOf(values[i]), 2);
    return gyro_.logLikelihood(with(values)) - priors / 2;
  }
  /// Moves these numbers, one at a time, by steps that are halved.
  double climb(StanceValues& values, const std::vector<std::size_t>& free) const {
    constexpr double kFirstStep = 8, kLastStep = 0.1;  // steps of a derivative
    double best = at(values);
    for (double step = kFirstStep; step > kLastStep; step /= 2) {
      for (const std::size_t i : free)
        for (const double by : {step, -step})
          for (;;) {
            StanceValues moved = values;
            moved[i] = byStep(i, values[i], by);
            const double value = at(moved);
            if (!(value > best)) break;
            best = value, values = std::move(moved);
          }
    }
    return best;
  }
  /// From the curvature of the likelihood.
  [[nodiscard]] StanceValues sigmasAt(const StanceValues& values, const std::vector<std::size_t>& free) const {
    StanceValues out(values.size(), 0);
    for (const std::size_t i : free) {
      StanceValues up = values, down = values;
      up[i] = byStep(i, values[i], 2), down[i] = byStep(i, values[i], -2);
      const double half = (up[i] - down[i]) / 2, curvature = (2 * at(values) - at(up) - at(down)) / (half * half);
      if (curvature > 0) out[i] = std::sqrt(thresholds::kStanceCorrelated / curvature);
    }
    return out;
  }

 private:
  [[nodiscard]] double byStep(std::size_t i, double value, double steps) const {
    const FloorEffect::Number& number = effect_.numbers[i];
    return number.fromSearch(number.inSearch(value) + steps * number.step);
  }

  const StanceGyro& gyro_;
  const ImuDeviation& base_;
  const FloorEffect& effect_;
};

/// Each number alone, and all of them; none of what is fixed.
std::vector<std::vector<std::size_t>> freeSets(const FloorEffect& effect) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < effect.numbers.size(); ++i)
    if (!effect.numbers[i].is_fixed) all.push_back(i);
  std::vector<std::vector<std::size_t>> out{all};
  for (std::size_t i = 0; all.size() > 1 && i < all.size(); ++i) out.push_back({all[i]});
  return out;
}

/// An engine's contacts give way by some milliseconds: no delay.
double withoutEffect(const StanceGyro& gyro, const ImuDeviation& base) {
  double best = gyro.logLikelihood(base);
  for (const double delay_s : thresholds::kStanceTiming) {
    ImuDeviation moved = base;
    moved.delay_s += delay_s;
    best = std::max(best, gyro.logLikelihood(moved));
  }
  return best;
}

struct StanceCandidate {
  FoundFloor found;
  double evidence = 0, gain = 0;
};

StanceCandidate candidateOf(const StanceFit& fit, const FloorEffect& effect, double without, double rows) {
  StanceCandidate best;
  best.evidence = -std::numeric_limits<double>::infinity();
  for (const std::vector<std::size_t>& free : freeSets(effect)) {
    StanceValues values = effect.neutral;
    double value = -std::numeric_limits<double>::infinity();
    for (const StanceValues& start : effect.starts)
      if (const double there = fit.at(start); there > value) value = there, values = start;
    // What is not free stays neutral.
    for (std::size_t i = 0; i < values.size() && !free.empty(); ++i)
      if (std::ranges::find(free, i) == free.end()) values[i] = effect.neutral[i];
    if (!free.empty()) value = fit.climb(values, free);
    const double price = free.empty()
                             ? 2 * std::log(static_cast<double>(effect.starts.size()))
                             : static_cast<double>(free.size()) * std::log(rows / thresholds::kCorrelatedSamples);
    const double evidence = 2 * (value - without) / thresholds::kStanceCorrelated - price;
    if (evidence <= best.evidence) continue;
    best = {.found = {.placed = {&effect, values}, .sigmas = fit.sigmasAt(values, free), .rivals = {}},
            .evidence = evidence,
            .gain = value - without};
  }
  return best;
}

}  // namespace

StanceSelection::StanceSelection(const BodyCase& given, const MovingImu& imu, const FloorModel& about)
    : base_{withRestingBias(given, about.imu)},
      fit_{given, imu, standingLogs(given, false), readingNoise(given, ImuSensor::kGyro)},
      held_out_{given, imu, standingLogs(given, true), readingNoise(given, ImuSensor::kGyro)} {}

std::optional<FoundFloor> StanceSelection::best(const std::vector<FloorEffect>& effects) const {
  if (fit_.rows() == 0) return std::nullopt;
  const auto rows = static_cast<double>(fit_.rows());
  const double without = withoutEffect(fit_, base_);
  std::vector<StanceCandidate> all;
  for (const FloorEffect& effect : effects)
    if (effect.is_of_sensor) all.push_back(candidateOf({fit_, base_, effect}, effect, without, rows));
  std::ranges::stable_sort(all, std::greater{}, &StanceCandidate::evidence);
  StanceCandidate& first = all.front();
  const double names = 2 * std::log(static_cast<double>(all.size()));
  if (!(first.evidence - names > -2 * std::log(thresholds::kMechanicalChance))) return std::nullopt;
  if (held_out_.rows() > 0) {
    const ImuDeviation found = StanceFit{held_out_, base_, *first.found.placed.effect}.with(first.found.placed.values);
    const double gain = held_out_.logLikelihood(found) - held_out_.logLikelihood(base_);
    if (gain / static_cast<double>(held_out_.rows()) < thresholds::kStanceHeldOut * first.gain / rows)
      return std::nullopt;
  }
  for (std::size_t i = 1; i < all.size(); ++i)
    if (first.evidence - all[i].evidence < thresholds::kRivalEvidence)
      first.found.rivals.push_back(all[i].found.placed);
  return first.found;
}

bool StanceSelection::refutes(const ImuDeviation& imu) const {
  ImuDeviation with = imu;
  with.gyro.bias = base_.gyro.bias;
  return fit_.logLikelihood(with) < fit_.logLikelihood(base_);
}

}  // namespace darwinop::gap
