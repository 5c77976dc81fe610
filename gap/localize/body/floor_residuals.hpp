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

/// Numbers that differ among engines: the difference is noise, but not for an effect that is this number.
enum class EngineNumber : std::uint8_t { kNone, kContactTime };

/// Simulated logs, in the order of FloorResiduals::logs().
using FloorTraces = std::vector<FloorTrace>;

/// Logs on the floor or lying that are held out, or the others. Not those of the runtime, whose servos are read between
/// two rows: on the floor that is not simulated, nor is a robot with a joint that never answers.
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
  [[nodiscard]] Eigen::VectorXd whitened(const Eigen::VectorXd& scaled) const { return noise_.modes.whitened(scaled); }
  [[nodiscard]] Eigen::VectorXd of(const FloorTraces& traces, const ImuDeviation& imu) const {
    return whitened(scaled(traces, imu));
  }
  /// Whitened, of a model that has a value of its own for this number.
  [[nodiscard]] Eigen::VectorXd of(const FloorTraces& traces, const ImuDeviation& imu, EngineNumber own) const;

  [[nodiscard]] const std::vector<FloorSamples>& blocks() const { return blocks_; }
  [[nodiscard]] Eigen::Index size() const { return noise_.sigma.size(); }
  [[nodiscard]] const Eigen::VectorXd& sigma() const { return noise_.sigma; }
  /// Share of each sample's variance that is common to its log: by how much one more right model would differ.
  [[nodiscard]] const Eigen::VectorXd& commonShare() const { return noise_.common; }

 private:
  [[nodiscard]] Eigen::VectorXd readings(const FloorTraces& traces, const ImuDeviation& imu) const;
  void estimateNoise(const FloorModel& about);
  /// What simulations differ by from the base, one a column.
  struct Ensemble {
    Eigen::MatrixXd repeats, engines, draws;
    std::vector<EngineNumber> numbers = {};  // of each column of `engines`
    [[nodiscard]] Ensemble without(EngineNumber number) const;
  };
  struct Noise {
    Eigen::VectorXd sigma, common;
    Eigen::MatrixXd directions;  // of noise, engine and priors, in sigmas
    NoiseModes modes = {};
  };
  [[nodiscard]] Ensemble simulateEnsemble(const FloorModel& about);
  /// Standard deviation of each sample; what is slow stays in the columns.
  [[nodiscard]] Eigen::VectorXd sigmaOf(Eigen::MatrixXd& repeats) const;
  [[nodiscard]] Noise noiseOf(const Ensemble& of, Eigen::VectorXd sigma) const;
  void setDirections(const Ensemble& of, Noise& into) const;
  void widenByWhatIsNotSpanned(const Ensemble& of, Noise& into) const;

  const BodyCase& given_;
  std::vector<std::size_t> logs_;
  const MovingImu& imu_;
  FloorTraces base_;
  std::vector<FloorSamples> blocks_;
  Eigen::VectorXd measured_;
  Noise noise_, noise_of_own_contact_;
};

}  // namespace darwinop::gap
