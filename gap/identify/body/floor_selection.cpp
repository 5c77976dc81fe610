#include "gap/identify/body/floor_selection.hpp"

#include <algorithm>
#include <cmath>

#include "gap/identify/body/floor_search.hpp"
#include "gap/identify/body/held_out_motion.hpp"
#include "gap/identify/body/mechanics_fit.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/localize/body/floor_rows.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

FloorSet setOf(const std::vector<FoundFloor>& found) {
  FloorSet out;
  for (const FoundFloor& one : found) out.push_back(one.placed);
  return out;
}

FloorErrors heldOutFloor(const BodyCase& given, const MovingImu& imu, const FloorModel& model) {
  double squares[3] = {}, counts[3] = {};
  const std::vector<std::size_t> logs = floorLogs(given, true);
  const FloorTraces traces = simulateFloor(given, logs, {model.robot}).front();
  const auto add = [&](int kind, const std::vector<double>& measured, const Eigen::VectorXd& expected) {
    for (std::size_t row = 0; row < measured.size(); ++row) {
      const double error = measured[row] - expected[static_cast<Eigen::Index>(row)];
      if (!std::isnan(error)) squares[kind] += error * error, counts[kind] += 1;
    }
  };
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const MovingImu::Readings sensed = imu.of(traces[i], model.imu);
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      add(0, given.joint(logs[i], joint).position_rad, traces[i].position_rad.col(static_cast<Eigen::Index>(joint)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto column = static_cast<Eigen::Index>(axis);
      add(1, given.logs[logs[i]].gyro_rad_s[axis], sensed.gyro_rad_s.col(column));
      add(2, given.logs[logs[i]].accel_m_s2[axis], sensed.accel_m_s2.col(column));
    }
  }
  return {std::sqrt(squares[0] / counts[0]), std::sqrt(squares[1] / counts[1]), std::sqrt(squares[2] / counts[2])};
}

/// Geometric mean of the ratios; NaN: nothing is held out.
double riseOf(const FloorErrors& after, const FloorErrors& before) {
  return std::cbrt(after.joints / before.joints * after.gyro / before.gyro * after.accel / before.accel);
}

/// One selection, from the model as it is to the last name that earns its place.
class FloorSearch {
 public:
  FloorSearch(const BodyCase& given, const FloorModel& about, const std::vector<Joint>& ignored, std::size_t other_rows)
      : given_{given},
        ignored_{ignored},
        logs_{floorLogs(given, false)},
        imu_{given.joints.model},
        residuals_{given, logs_, imu_, about, ignored},
        open_from_{sigmasOfChance(thresholds::kFalseDiscoveries / static_cast<double>(other_rows + kFloorSignals))},
        evaluator_{given, residuals_, about} {
    out_.effects = std::make_shared<const std::vector<FloorEffect>>(floorEffects(given.joints.model));
    out_.rows = out_.rows_after = rowsWith(residuals_, {});
    out_.held_out_before = out_.held_out_after = heldOutFloor(given, imu_, about);
    excess_of_none_ = excessOf({});
  }

  FloorSelection run() {
    while (isOpen(out_.rows_after) && out_.found.size() < thresholds::kMostFloorEffects && addNext()) {
    }
    if (out_.found.empty()) return std::move(out_);
    if (!isVerified(out_.held_out_before, out_.held_out_after, areOfSensors()))
      dropAll();
    else if (isOpen(out_.rows_after))
      checkRemainder();
    return std::move(out_);
  }

 private:
  std::vector<BodyRow> rowsWith(const FloorResiduals& residuals, const FloorSet& set) {
    std::vector<BodyRow> rows = floorRows(given_, residuals, evaluator_.tracesOf(set), evaluator_.modelOf(set).imu);
    for (BodyRow& row : rows) row.open = row.significance > open_from_;
    return rows;
  }
  [[nodiscard]] bool areOfSensors() const {
    return std::ranges::all_of(out_.found, [](const FoundFloor& one) { return one.placed.effect->is_of_sensor; });
  }
  static bool isOpenRow(const BodyRow& row) { return row.open; }
  static bool isOpen(const std::vector<BodyRow>& rows) { return std::ranges::any_of(rows, isOpenRow); }
  double costWith(const FloorSet& set) { return costOf(set, evaluator_.residuals({set}).front()); }
  /// Cost beyond that of noise.
  double excessOf(const FloorSet& set) {
    return costWith(set) - static_cast<double>(evaluator_.size()) * thresholds::kFloorCostOfNoise;
  }

  /// The best of all further names. False: it does not earn its place.
  bool addNext() {
    const FloorSet now = setOf(out_.found);
    const double cost = costWith(now);
    const std::vector<FloorCandidate> candidates = nextFloorEffects(evaluator_, *out_.effects, now, cost);
    if (candidates.empty()) return false;
    const FloorCandidate& best = candidates.front();
    const double least =
        std::max(thresholds::kFloorShare * excessOf(now), thresholds::kMechanicsRemainder * excess_of_none_);
    if (!(best.evidence > -2 * std::log(thresholds::kMechanicalChance) && cost - best.fit.cost > least)) return false;
    const FloorErrors errors = heldOutFloor(given_, imu_, evaluator_.modelOf(best.fit.set));
    if (riseOf(errors, out_.held_out_after) > thresholds::kHeldOutRise) {
      out_.tried.push_back(best.fit.set.back());
      return false;
    }
    std::vector<PlacedFloor> rivals;
    for (std::size_t i = 1; i < candidates.size(); ++i)
      if (best.evidence - candidates[i].evidence < thresholds::kRivalEvidence)
        rivals.push_back(candidates[i].fit.set.back());
    out_.found.push_back({.placed = {}, .sigmas = {}, .rivals = std::move(rivals)});
    for (std::size_t i = 0; i < out_.found.size(); ++i)
      out_.found[i].placed = best.fit.set[i], out_.found[i].sigmas = best.fit.sigmas[i];
    out_.held_out_after = errors;
    out_.rows_after = rowsWith(residuals_, setOf(out_.found));
    return true;
  }

  void dropAll() {
    for (const FoundFloor& one : out_.found) out_.tried.push_back(one.placed);
    out_.found.clear();
    out_.rows_after = out_.rows, out_.held_out_after = out_.held_out_before;
  }

  /// What is left may be chaos of the model that was found, which its own repeats show.
  void checkRemainder() {
    const FloorSet found = setOf(out_.found);
    const FloorResiduals about_found{given_, logs_, imu_, evaluator_.modelOf(found), ignored_};
    evaluator_.useNoiseOf(about_found);
    const double none = excessOf({}), left = excessOf(found);
    out_.rows_after = rowsWith(about_found, found);
    // An effect of sensors answers for their rows alone, which follow the joints': what the limbs do is not its.
    const bool is_explained = areOfSensors()
                                  ? std::none_of(out_.rows_after.begin() + kJoints, out_.rows_after.end(), isOpenRow)
                                  : left < (1 - thresholds::kExplainedGapShare) * none;
    if (isOpen(out_.rows_after) && !is_explained) dropAll();
    evaluator_.useNoiseOf(residuals_);
  }

  const BodyCase& given_;
  const std::vector<Joint>& ignored_;
  const std::vector<std::size_t> logs_;
  const MovingImu imu_;
  const FloorResiduals residuals_;
  const double open_from_;
  FloorEvaluator evaluator_;
  FloorSelection out_;
  double excess_of_none_ = 0;
};

}  // namespace

bool isVerified(const FloorErrors& before, const FloorErrors& after, bool by_gyro) {
  const double noise = by_gyro ? stepOf(ImuSensor::kGyro) * std::hypot(0.5, 1 / std::sqrt(12.0)) : kEncoderNoise;
  const double from = by_gyro ? before.gyro : before.joints, to = by_gyro ? after.gyro : after.joints;
  const bool remains = to > thresholds::kRemainingFloors * noise;
  return !remains || to * to - noise * noise < (1 - thresholds::kExplainedGapShare) * (from * from - noise * noise);
}

FloorSelection identifyFloor(const BodyCase& given, const FloorModel& about, const std::vector<Joint>& ignored,
                             std::size_t other_rows) {
  if (!canSimulateFloor(given)) return {};
  return FloorSearch{given, about, ignored, other_rows}.run();
}

}  // namespace darwinop::gap
