// Which numbers of an inertial sensor postures at rest determine, and how well.
#include "apps/calibrate/imu_fit.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "apps/calibrate/imu_text.hpp"
#include "connect/robot_file.hpp"
#include "core/random.hpp"

namespace darwinop::calibrate {
namespace {

using cm730::ImuCalibration;

constexpr double kSigma = 0.005;    // m/s2, of a mean
constexpr double kLevelDeg = 0.01;  // the trunk is levelled exactly

ImuCalibration hidden() {
  return {.gyro_bias_rad_s = {0.1, -0.05, 0.02},
          .accel_bias_m_s2 = {0.3, -0.2, 0.15},
          .accel_scale = {1.02, 0.99, 1.01},
          .mounting_rad = {0.03, -0.02, 0.015}};
}

PostureReading readingIn(const TrunkPosture& posture, const ImuCalibration& truth) {
  const cm730::ImuCorrection sensor{truth};
  StillReading reading{.samples = 300};
  reading.accel = sensor.rawAccelerometer(posture.gravity());
  reading.gyro = sensor.rawGyro({0, 0, 0});
  reading.accel_sigma.fill(kSigma);
  reading.gyro_sigma.fill(0.001);
  return {&posture, reading};
}

std::vector<PostureReading> readings(std::size_t count, const ImuCalibration& truth = hidden()) {
  std::vector<PostureReading> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(readingIn(kPostures[i], truth));
  return out;
}

void expectNear(const Axes& found, const Axes& truth, double within) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], truth[i], within) << "axis " << i;
}

TEST(ImuFit, SixPosturesDetermineEveryNumber) {
  const ImuFit fit = fitImu(readings(6), kLevelDeg, {});
  EXPECT_TRUE(fit.observed);
  expectNear(fit.calibration.gyro_bias_rad_s, hidden().gyro_bias_rad_s, 1e-9);
  expectNear(fit.calibration.accel_bias_m_s2, hidden().accel_bias_m_s2, 0.002);
  expectNear(fit.calibration.accel_scale, hidden().accel_scale, 0.0002);
  expectNear(fit.calibration.mounting_rad, hidden().mounting_rad, 0.0002);
}

TEST(ImuFit, ReportsTheErrorBeforeAndAfterAndOfAPostureThatItHasNotSeen) {
  const ImuFit fit = fitImu(readings(6), kLevelDeg, {});
  ASSERT_EQ(fit.errors.size(), 6U);
  for (const PostureError& error : fit.errors) {
    EXPECT_GT(error.before_deg, 0.5) << error.posture->name;
    EXPECT_LT(error.after_deg, 0.02) << error.posture->name;
    EXPECT_LT(error.predicted_deg, 0.1) << error.posture->name;
  }
}

TEST(ImuFit, OneOrTwoPosturesAreNotEnoughAndSaySo) {
  EXPECT_FALSE(fitImu(readings(1), kLevelDeg, {}).observed);
  EXPECT_FALSE(fitImu(readings(2), kLevelDeg, {}).observed);
  EXPECT_FALSE(fitImu({}, kLevelDeg, {}).observed);
}

TEST(ImuFit, TheErrorOfTheLevelIsInTheStandardDeviation) {
  const ImuFit exact = fitImu(readings(6), kLevelDeg, {}), rough = fitImu(readings(6), 2, {});
  EXPECT_LT(exact.sigma.mounting_rad[0], 0.001);
  EXPECT_NEAR(rough.sigma.mounting_rad[0], 2 * kRadPerDegree / std::sqrt(4.0), 0.003);  // four postures show each axis
}

TEST(ImuFit, KeysOfRobotIniReadBackAsTheSameCalibration) {
  const ImuFit fit = fitImu(readings(6), kLevelDeg, {});
  const std::string text = withValues("", "Imu", iniValues(fit, "2026-11-26"));
  const ImuCalibration read = connect::parseRobotFile(text, "robot.ini").imu;
  expectNear(read.mounting_rad, fit.calibration.mounting_rad, 1e-5);
  expectNear(read.accel_scale, fit.calibration.accel_scale, 1e-5);
  expectNear(read.accel_bias_m_s2, fit.calibration.accel_bias_m_s2, 1e-5);
  expectNear(read.gyro_bias_rad_s, fit.calibration.gyro_bias_rad_s, 1e-5);
  EXPECT_THAT(text, testing::HasSubstr("2026-11-26"));
}

TEST(MeanOf, AQuietSensorIsNoFinerThanItsRegister) {
  constexpr double kStep = 0.08;
  const std::vector<double> quiet(300, 0.16);
  double mean = 0, sigma = 0;
  meanOf(quiet, kStep, mean, sigma);
  EXPECT_NEAR(mean, 0.16, 1e-9);
  EXPECT_NEAR(sigma, kStep / std::sqrt(12.0), 1e-6);
}

TEST(MeanOf, SlowDriftCountsAsAnErrorOfTheMean) {
  std::vector<double> drifting;
  for (int i = 0; i < 300; ++i) drifting.push_back(std::sin(i / 100.0));
  double mean = 0, sigma = 0;
  meanOf(drifting, 0.001, mean, sigma);
  EXPECT_GT(sigma, 0.08);  // white noise of this size would have 0.02
}

}  // namespace
}  // namespace darwinop::calibrate
