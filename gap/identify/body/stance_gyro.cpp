#include "gap/identify/body/stance_gyro.hpp"

#include <cmath>
#include <limits>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

// Of each foot: it stands and gives way about its forward axis, in which robots rock; it rolls on a side; it tips on
// toe or heel. And no foot stands.
constexpr Eigen::Index kContactsOfFoot = 3, kContacts = 2 * kContactsOfFoot + 1;
using Contacts = Eigen::Matrix<double, kContacts, 1>;

// s before a fall in which no foot stands: a robot tips over as an inverted pendulum does, e-fold in 0.17 s at a height
// of 0.28 m, and takes three of these from a degree to where a fall is noticed.
constexpr double kTipsOver = 0.5;

double logDensity(double square, double sigma) {
  return -0.5 * square / (sigma * sigma) - std::log(sigma);
}

}  // namespace

StanceGyro::StanceGyro(const BodyCase& given, const MovingImu& imu, const std::vector<std::size_t>& logs,
                       const Eigen::Vector3d& noise_rad_s)
    : imu_{imu}, sigma_{std::hypot(noise_rad_s.norm() / std::sqrt(3.0), thresholds::kStanceNoise)} {
  for (const std::size_t log : logs) {
    Log one{.feet = stanceRates(given, log), .measured = {}};
    one.measured.resize(static_cast<Eigen::Index>(given.logs[log].rows()), 3);
    for (Eigen::Index row = 0; row < one.measured.rows(); ++row)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        one.measured(row, axis) =
            given.logs[log].gyro_rad_s[static_cast<std::size_t>(axis)][static_cast<std::size_t>(row)];
    if (const auto fall_s = given.logs[log].fell_at_s)
      for (Eigen::Index row = 0; row < one.measured.rows(); ++row)
        if (given.logs[log].time_s[static_cast<std::size_t>(row)] > *fall_s - kTipsOver)
          one.measured.row(row).setConstant(std::numeric_limits<double>::quiet_NaN());
    for (Eigen::Index row = 0; row < one.measured.rows(); ++row)
      if (!one.measured.row(row).hasNaN()) ++rows_;
    logs_.push_back(std::move(one));
  }
}

double StanceGyro::ofLog(const Log& log, const ImuDeviation& imu) const {
  constexpr double kWide = thresholds::kStanceRocking;
  const double roll = std::hypot(sigma_, thresholds::kStanceRoll);
  // What is read for each foot, and the directions in which it reads a rotation of that foot.
  std::array<Eigen::MatrixX3d, 2> expected, forward, left;
  const Eigen::Matrix3d read = imu_.gyroMatrix(imu).transpose();
  for (std::size_t foot = 0; foot < 2; ++foot) {
    expected[foot] = imu_.of(log.feet[foot].trace, imu).gyro_rad_s;
    forward[foot] = (log.feet[foot].forward * read).rowwise().normalized();
    left[foot] = (log.feet[foot].left * read).rowwise().normalized();
  }
  Contacts chance = Contacts::Constant(1.0 / static_cast<double>(kContacts));
  double sum = 0;
  for (Eigen::Index row = 0; row < log.measured.rows(); ++row) {
    chance = Contacts{thresholds::kStanceStay * chance.array() +
                      (1 - thresholds::kStanceStay) / (kContacts - 1) * (1 - chance.array())};
    const auto r = static_cast<std::size_t>(row);
    if (log.measured.row(row).hasNaN() || !log.feet[0].known[r] || !log.feet[1].known[r]) continue;
    Contacts fits;
    for (Eigen::Index foot = 0; foot < 2; ++foot) {
      const auto f = static_cast<std::size_t>(foot);
      const Eigen::RowVector3d off = log.measured.row(row) - expected[f].row(row);
      const double all = off.squaredNorm(), rolls = std::pow(off.dot(forward[f].row(row)), 2),
                   pitches = std::pow(off.dot(left[f].row(row)), 2);
      // Two of three components of the difference are noise, the third is what the foot turns by.
      const auto with = [&](double free, double sigma) {
        return logDensity(all - free, sigma_) - std::log(sigma_) + logDensity(free, sigma);
      };
      fits.segment<kContactsOfFoot>(kContactsOfFoot * foot) << with(rolls, roll), with(rolls, kWide),
          with(pitches, kWide);
    }
    fits[kContacts - 1] = logDensity(log.measured.row(row).squaredNorm(), kWide) - 2 * std::log(kWide);
    const double most = fits.maxCoeff();
    chance = Contacts{chance.array() * (fits.array() - most).exp()};
    sum += most + std::log(chance.sum());
    chance /= chance.sum();
  }
  return sum;
}

double StanceGyro::logLikelihood(const ImuDeviation& imu) const {
  double sum = 0;
  for (const Log& log : logs_) sum += ofLog(log, imu);
  return sum;
}

}  // namespace darwinop::gap
