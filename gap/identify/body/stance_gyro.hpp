// How likely the readings of a gyroscope are, by the kinematics of the feet that stand: a hidden Markov model of which
// foot stands, rolls on a side or tips on toe or heel, or neither. No contact is simulated.
#pragma once

#include <vector>

#include "gap/plant/body/moving_imu.hpp"
#include "gap/plant/body/stance_rates.hpp"

namespace darwinop::gap {

class StanceGyro {
 public:
  /// `logs`: on the floor. `noise_rad_s`: of one reading.
  StanceGyro(const BodyCase& given, const MovingImu& imu, const std::vector<std::size_t>& logs,
             const Eigen::Vector3d& noise_rad_s);

  /// Log likelihood of the readings of all logs.
  [[nodiscard]] double logLikelihood(const ImuDeviation& imu) const;
  /// Rows with a reading.
  [[nodiscard]] std::size_t rows() const { return rows_; }

 private:
  struct Log {
    std::array<StanceRates, 2> feet;
    Eigen::MatrixX3d measured;
  };
  [[nodiscard]] double ofLog(const Log& log, const ImuDeviation& imu) const;

  const MovingImu& imu_;
  std::vector<Log> logs_;
  double sigma_;
  std::size_t rows_ = 0;
};

}  // namespace darwinop::gap
