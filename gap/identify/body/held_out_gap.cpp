#include "gap/identify/body/held_out_gap.hpp"

#include <array>
#include <cmath>

#include "gap/localize/body/limb_residuals.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/body/resting_imu.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr Eigen::Index kFirstOfGyro = kJoints;  // its three columns, then those of the accelerometer

/// Positions of all joints, then the axes of gyroscope and accelerometer: rows of one log x signals.
using Signals = Eigen::MatrixXd;

Signals measuredIn(const BodyCase& given, std::size_t log) {
  const BodyLog& of = given.logs[log];
  Signals out = Signals::Constant(static_cast<Eigen::Index>(of.rows()), kFloorSignals, kUnknown);
  for (std::size_t signal = 0; signal < kFloorSignals; ++signal) {
    const std::vector<double>& column = signal < kJoints       ? given.joint(log, signal).position_rad
                                        : signal < kJoints + 3 ? of.gyro_rad_s[signal - kJoints]
                                                               : of.accel_m_s2[signal - kJoints - 3];
    std::ranges::copy(column, out.col(static_cast<Eigen::Index>(signal)).begin());
  }
  return out;
}

class HeldOutSimulation {
 public:
  HeldOutSimulation(const BodyCase& given)
      : given_{given}, resting_{given.joints.model}, moving_{given.joints.model}, limbs_{limbsOf(given.joints.model)} {}

  [[nodiscard]] Signals of(std::size_t log, const FloorModel& model, const Disturbance* noise) const {
    Signals out = atRest(log, model.imu);
    if (given_.logs[log].setup != BodySetup::kClamped) {
      const FloorTrace trace = rollOut(given_, log, model.robot, noise);
      const MovingImu::Readings sensed = moving_.of(trace, model.imu);
      out << trace.position_rad, sensed.gyro_rad_s, sensed.accel_m_s2;
      return out;
    }
    for (const Limb& limb : limbs_) {
      const LimbTrace trace = rollOut(given_, log, limb, model.robot.robot, noise);
      for (std::size_t i = 0; i < limb.size(); ++i)
        out.col(static_cast<Eigen::Index>(limb[i].joint)) = trace.position_rad.col(static_cast<Eigen::Index>(i));
    }
    return out;
  }
  /// Without limbs that have a joint which never answers.
  [[nodiscard]] Signals simulatedOf(Signals measured) const {
    for (const Limb& limb : limbs_)
      if (!isRecorded(given_, limb))
        for (const Link& link : limb) measured.col(static_cast<Eigen::Index>(link.joint)).setConstant(kUnknown);
    return measured;
  }
  /// Sensors of a clamped trunk alone.
  [[nodiscard]] Signals atRest(std::size_t log, const ImuDeviation& imu) const {
    const BodyLog& of = given_.logs[log];
    Signals out = Signals::Constant(static_cast<Eigen::Index>(of.rows()), kFloorSignals, kUnknown);
    if (!of.up) return out;
    const Eigen::Vector3d up{(*of.up)[0], (*of.up)[1], (*of.up)[2]};
    out.middleCols<3>(kJoints).rowwise() = resting_.reading(ImuSensor::kGyro, up, imu.gyro).transpose();
    out.rightCols<3>().rowwise() = resting_.reading(ImuSensor::kAccelerometer, up, imu.accel).transpose();
    return out;
  }

 private:
  const BodyCase& given_;
  const RestingImu resting_;
  const MovingImu moving_;
  const std::vector<Limb> limbs_;
};

/// Sums of squares of the three groups.
class GapSum {
 public:
  /// `measured`: what is missing there does not count. `variance`: of each signal, on top. NaN in `difference`: the
  /// simulation failed, and the rms of its group is not known.
  void add(const Signals& measured, const Signals& difference, const Eigen::VectorXd& variance) {
    for (Eigen::Index signal = 0; signal < difference.cols(); ++signal)
      for (Eigen::Index row = 0; row < difference.rows(); ++row) {
        if (std::isnan(measured(row, signal))) continue;
        const double one = difference(row, signal);
        const std::size_t group = signal < kFirstOfGyro ? 0 : signal < kFirstOfGyro + 3 ? 1 : 2;
        squares_[group] += one * one + variance[signal], counts_[group] += 1;
      }
  }
  [[nodiscard]] GapErrors rms() const {
    const auto of = [&](std::size_t group) { return std::sqrt(squares_[group] / counts_[group]); };
    return {of(0), of(1), of(2)};
  }

 private:
  std::array<double, 3> squares_{}, counts_{};
};

/// Of one reading of each signal, beside what a repeat of the motion shows.
Eigen::VectorXd readingVariance(const BodyCase& given) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(kFloorSignals);
  out.segment<3>(kJoints) = readingNoise(given, ImuSensor::kGyro).cwiseAbs2();
  out.tail<3>() = readingNoise(given, ImuSensor::kAccelerometer).cwiseAbs2();
  return out;
}

}  // namespace

HeldOutGap heldOutGap(const BodyCase& given, const FloorModel& declared, const FloorModel& final_model) {
  if (given.joints.model.servo.law != twin::Law::kVoltageP) return heldOutGapAtRest(given, final_model.imu);
  std::vector<std::size_t> logs = clampedLogs(given, true);
  for (const std::size_t log : floorLogs(given, true)) logs.push_back(log);
  const HeldOutSimulation simulation{given};
  constexpr std::size_t kRuns = 2 + thresholds::kHeldOutRepeats;  // before, after, and repeats of after
  std::vector<Signals> runs(kRuns * logs.size());
  forEach(runs.size(), [&](std::size_t i) {
    const std::size_t log = i / kRuns, run = i % kRuns;
    const Disturbance noise{.seed = (run + 1) * 64 + log};
    runs[i] = simulation.of(logs[log], run == 0 ? declared : final_model, run < 2 ? nullptr : &noise);
  });
  GapSum before, after, floor;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(kFloorSignals), variance = readingVariance(given);
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const Signals measured = simulation.simulatedOf(measuredIn(given, logs[i])), *const of = &runs[kRuns * i];
    before.add(measured, measured - of[0], none);
    after.add(measured, measured - of[1], none);
    for (std::size_t run = 2; run < kRuns; ++run) floor.add(measured, of[run] - of[1], variance);
  }
  return {before.rms(), after.rms(), floor.rms()};
}

HeldOutGap heldOutGapAtRest(const BodyCase& given, const ImuDeviation& final_imu) {
  const HeldOutSimulation simulation{given};
  GapSum before, after, floor;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(kFloorSignals), variance = readingVariance(given);
  for (const std::size_t log : clampedLogs(given, true)) {
    const Signals measured = measuredIn(given, log), expected = simulation.atRest(log, final_imu);
    before.add(measured, measured - simulation.atRest(log, {}), none);
    after.add(measured, measured - expected, none);
    floor.add(measured, expected - expected, variance);
  }
  return {before.rms(), after.rms(), floor.rms()};
}

}  // namespace darwinop::gap
