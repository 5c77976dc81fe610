// Measured minus simulated signals of a robot on the floor, whitened: what noise, chaos of contacts, another physics
// engine and numbers within their priors explain counts once, not once a sample.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/localize/body/noise_modes.hpp"
#include "gap/plant/body/floor_roll_out.hpp"
#include "gap/plant/body/moving_imu.hpp"

namespace darwinop::gap {

/// Signals of one log: position of each joint, then x, y, z of gyroscope and of accelerometer.
inline constexpr std::size_t kFloorSignals = kJoints + 6;
/// "AnkleR.position", "gyro.x"; and its unit.
std::string floorSignal(std::size_t signal);
std::string_view floorUnit(std::size_t signal);

/// Samples of one signal in one log: all its rows.
struct FloorSamples {
  std::size_t log, signal;
  Eigen::Index begin, rows;
};

/// A model of the robot with its sensors.
struct FloorModel {
  FloorHypothesis robot;
  ImuDeviation imu = {};
};

/// Simulated logs, in the order of FloorResiduals::logs().
using FloorTraces = std::vector<FloorTrace>;

/// Logs on the floor or lying that are held out, or the others. Not those of the runtime, whose servos are read between
/// two rows: on the floor that is not simulated.
std::vector<std::size_t> floorLogs(const BodyCase& given, bool held_out);

/// There is such a log for fits, and the servos' law can be simulated.
bool canSimulateFloor(const BodyCase& given);

/// Roll-outs of all hypotheses on all logs, in parallel.
std::vector<FloorTraces> simulateFloor(const BodyCase& given, const std::vector<std::size_t>& logs,
                                       const std::vector<FloorHypothesis>& hypotheses);

class FloorResiduals {
 public:
  /// Noise, engine and priors are those of robots near `about`. Simulates some dozen times. Positions of ignored joints
  /// do not count.
  FloorResiduals(const BodyCase& given, std::vector<std::size_t> logs, const MovingImu& imu, const FloorModel& about,
                 const std::vector<Joint>& ignored = {});

  [[nodiscard]] std::vector<FloorTraces> simulate(const std::vector<FloorHypothesis>& hypotheses) const {
    return simulateFloor(given_, logs_, hypotheses);
  }
  /// Of the model that the noise is about.
  [[nodiscard]] const FloorTraces& baseTraces() const { return base_; }

  /// Measured - simulated; NaN: not measured, or not simulated.
  [[nodiscard]] Eigen::VectorXd raw(const FloorTraces& traces, const ImuDeviation& imu) const;
  /// In standard deviations of one sample; a missing sample is 0.
  [[nodiscard]] Eigen::VectorXd scaled(const FloorTraces& traces, const ImuDeviation& imu) const;
  /// Of such residuals or of their derivatives. Linear.
  [[nodiscard]] Eigen::VectorXd whitened(const Eigen::VectorXd& scaled) const { return modes_.whitened(scaled); }
  [[nodiscard]] Eigen::VectorXd of(const FloorTraces& traces, const ImuDeviation& imu) const {
    return whitened(scaled(traces, imu));
  }

  [[nodiscard]] const std::vector<FloorSamples>& blocks() const { return blocks_; }
  [[nodiscard]] Eigen::Index size() const { return sigma_.size(); }
  [[nodiscard]] const Eigen::VectorXd& sigma() const { return sigma_; }
  /// Share of each sample's variance that is common to its log: by how much one more right model would differ.
  [[nodiscard]] const Eigen::VectorXd& commonShare() const { return common_; }

 private:
  [[nodiscard]] Eigen::VectorXd readings(const FloorTraces& traces, const ImuDeviation& imu) const;
  void estimateNoise(const FloorModel& about);
  /// What simulations differ by from the base, one a column.
  struct Ensemble {
    Eigen::MatrixXd repeats, engines, draws;
  };
  [[nodiscard]] Ensemble simulateEnsemble(const FloorModel& about);
  void setSigma(Eigen::MatrixXd& repeats);
  void setDirections(const Ensemble& of);
  void widenByWhatIsNotSpanned(const Ensemble& of);

  const BodyCase& given_;
  std::vector<std::size_t> logs_;
  const MovingImu& imu_;
  FloorTraces base_;
  std::vector<FloorSamples> blocks_;
  Eigen::VectorXd measured_, sigma_, common_;
  Eigen::MatrixXd directions_;  // of noise, engine and priors, in sigmas
  NoiseModes modes_;
};

}  // namespace darwinop::gap
