#include "gap/localize/body/floor_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

std::string floorSignal(std::size_t signal) {
  if (signal < kJoints) return std::string{kJointTable[signal].name} + ".position";
  const std::size_t axis = (signal - kJoints) % 3;
  const ImuSensor sensor = signal < kJoints + 3 ? ImuSensor::kGyro : ImuSensor::kAccelerometer;
  return std::string{name(sensor)} + "." + "xyz"[axis];
}

std::string_view floorUnit(std::size_t signal) {
  if (signal < kJoints) return "rad";
  return unitOf(signal < kJoints + 3 ? ImuSensor::kGyro : ImuSensor::kAccelerometer);
}

std::vector<std::size_t> floorLogs(const BodyCase& given, bool held_out) {
  std::vector<std::size_t> logs;
  if (!given.isComplete()) return logs;
  for (std::size_t i = 0; i < given.logs.size(); ++i)
    if (given.logs[i].setup != BodySetup::kClamped && given.logs[i].held_out == held_out &&
        !given.joint(i, 0).isReadAfterWrite())
      logs.push_back(i);
  return logs;
}

bool canSimulateFloor(const BodyCase& given) {
  return given.joints.model.servo.law == twin::Law::kVoltageP && !floorLogs(given, false).empty();
}

std::vector<FloorTraces> simulateFloor(const BodyCase& given, const std::vector<std::size_t>& logs,
                                       const std::vector<FloorHypothesis>& hypotheses) {
  std::vector<FloorTraces> out(hypotheses.size(), FloorTraces(logs.size()));
  forEach(hypotheses.size() * logs.size(), [&](std::size_t i) {
    const std::size_t which = i / logs.size(), log = i % logs.size();
    out[which][log] = rollOut(given, logs[log], hypotheses[which]);
  });
  return out;
}

FloorResiduals::FloorResiduals(const BodyCase& given, std::vector<std::size_t> logs, const MovingImu& imu,
                               const FloorModel& about, const std::vector<Joint>& ignored)
    : given_{given}, logs_{std::move(logs)}, imu_{imu} {
  Eigen::Index size = 0;
  for (const std::size_t log : logs_)
    for (std::size_t signal = 0; signal < kFloorSignals; ++signal) {
      const auto rows = static_cast<Eigen::Index>(given.logs[log].rows());
      blocks_.push_back({log, signal, size, rows});
      size += rows;
    }
  measured_.resize(size);
  for (const FloorSamples& block : blocks_) {
    const BodyLog& log = given.logs[block.log];
    const std::vector<double>& column = block.signal < kJoints       ? given.joint(block.log, block.signal).position_rad
                                        : block.signal < kJoints + 3 ? log.gyro_rad_s[block.signal - kJoints]
                                                                     : log.accel_m_s2[block.signal - kJoints - 3];
    std::ranges::copy(column, measured_.begin() + block.begin);
    if (block.signal < kJoints && std::ranges::find(ignored, static_cast<Joint>(block.signal)) != ignored.end())
      measured_.segment(block.begin, block.rows).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  estimateNoise(about);
}

FloorResiduals::Noise FloorResiduals::noiseOf(const Ensemble& of, Eigen::VectorXd sigma) const {
  Noise out{.sigma = std::move(sigma), .common = {}, .directions = {}};
  setDirections(of, out);
  forgetUnmeasured(measured_, out.directions);
  widenByWhatIsNotSpanned(of, out);
  out.modes = NoiseModes{out.directions};
  out.directions.resize(0, 0);
  return out;
}

FloorResiduals::Ensemble FloorResiduals::Ensemble::without(EngineNumber number) const {
  Ensemble out{.repeats = repeats, .engines = engines, .draws = draws};
  Eigen::Index kept = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == number) continue;
    out.engines.col(kept++) = engines.col(static_cast<Eigen::Index>(i));
    out.numbers.push_back(numbers[i]);
  }
  out.engines.conservativeResize(Eigen::NoChange, kept);
  return out;
}

Eigen::VectorXd FloorResiduals::readings(const FloorTraces& traces, const ImuDeviation& imu) const {
  Eigen::VectorXd out(measured_.size());
  for (std::size_t i = 0; i < logs_.size(); ++i) {
    const MovingImu::Readings sensed = imu_.of(traces[i], imu);
    for (std::size_t signal = 0; signal < kFloorSignals; ++signal) {
      const FloorSamples& block = blocks_[i * kFloorSignals + signal];
      const auto axis = static_cast<Eigen::Index>(signal - kJoints);
      auto into = out.segment(block.begin, block.rows);
      if (signal < kJoints)
        into = traces[i].position_rad.col(static_cast<Eigen::Index>(signal));
      else if (signal < kJoints + 3)
        into = sensed.gyro_rad_s.col(axis);
      else
        into = sensed.accel_m_s2.col(axis - 3);
    }
  }
  return out;
}

Eigen::VectorXd FloorResiduals::raw(const FloorTraces& traces, const ImuDeviation& imu) const {
  return measured_ - readings(traces, imu);
}

Eigen::VectorXd FloorResiduals::scaled(const FloorTraces& traces, const ImuDeviation& imu) const {
  return inSigmas(raw(traces, imu), measured_, noise_.sigma);
}

Eigen::VectorXd FloorResiduals::of(const FloorTraces& traces, const ImuDeviation& imu, EngineNumber own) const {
  const Noise& noise = own == EngineNumber::kContactTime ? noise_of_own_contact_ : noise_;
  return noise.modes.whitened(inSigmas(raw(traces, imu), measured_, noise.sigma));
}

}  // namespace darwinop::gap
