// A twin with hidden errors of its inertial sensor: they are found, written, and the runtime then reads true values.
#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "apps/calibrate/imu_procedure.hpp"
#include "apps/calibrate/messages.hpp"
#include "apps/calibrate/twin_bench.hpp"
#include "core/random.hpp"

namespace darwinop::calibrate {
namespace {

using cm730::ImuCalibration;
using std::chrono::seconds;

const std::atomic<bool> kRunning{false};

std::vector<PostureReading> readAll(TwinBench& bench, const ImuCalibration& corrected_by = {}) {
  std::ostringstream log;
  return readPostures(*bench.link, *bench.stand, corrected_by, seconds{4}, kRunning, log);
}

twin::Model modelOf(const ImuCalibration& truth, double noise_m_s2) {
  twin::Model model = shippedModel();
  // [imu] of a model has the trunk's axes: left, up, forward.
  const Axes& r = truth.mounting_rad;
  model.imu.mounting_rad = {-r[0], r[2], r[1]};
  model.imu.accel_bias_m_s2 = truth.accel_bias_m_s2;
  model.imu.accel_scale = truth.accel_scale;
  model.imu.gyro_bias_rad_s = truth.gyro_bias_rad_s;
  model.imu.accel_noise_m_s2 = noise_m_s2;
  model.imu.gyro_noise_rad_s = 0.02;
  return model;
}

/// 2 deg about a random axis, biases and scales within the sensor's data sheet.
ImuCalibration hiddenBy(std::uint64_t seed) {
  Rng random{seed};
  const auto within = [&](double most) { return random.between(-most, most); };
  ImuCalibration truth;
  Axes& axis = truth.mounting_rad;
  for (double& r : axis) r = within(1);
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (double& r : axis) r *= 2 * kRadPerDegree / length;
  for (double& bias : truth.accel_bias_m_s2) bias = within(0.5);
  for (double& scale : truth.accel_scale) scale = 1 + within(0.03);
  for (double& bias : truth.gyro_bias_rad_s) bias = within(0.15);
  return truth;
}

double degreesBetween(const Axes& a, const Axes& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / kRadPerDegree;
}

struct HiddenImu : testing::TestWithParam<std::uint64_t> {};

TEST_P(HiddenImu, IsFoundWithinATenthOfADegreeAndItsBiases) {
  const ImuCalibration truth = hiddenBy(GetParam());
  TwinBench bench{modelOf(truth, 0.06), GetParam()};
  const ImuFit fit = fitImu(readAll(bench), 0.1, {});
  ASSERT_TRUE(fit.observed);
  EXPECT_LT(degreesBetween(fit.calibration.mounting_rad, truth.mounting_rad), 0.1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(fit.calibration.accel_bias_m_s2[i], truth.accel_bias_m_s2[i], 0.02) << "axis " << i;
    EXPECT_NEAR(fit.calibration.accel_scale[i], truth.accel_scale[i], 0.003) << "axis " << i;
    EXPECT_NEAR(fit.calibration.gyro_bias_rad_s[i], truth.gyro_bias_rad_s[i], 0.03) << "axis " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, HiddenImu, testing::Values(1, 2, 3, 4));

TEST(CalibratedImu, TheRuntimeReadsTrueValues) {
  const ImuCalibration truth = hiddenBy(7);
  TwinBench before{modelOf(truth, 0.06)};
  const ImuFit fit = fitImu(readAll(before), 0.1, {});
  TwinBench after{modelOf(truth, 0.06), 2, {.offsets = {}, .imu = fit.calibration}};
  const std::vector<PostureReading> read = readAll(after);  // as the runtime shows them
  ASSERT_EQ(read.size(), kPostures.size());
  for (const PostureReading& one : read) {
    EXPECT_LT(tiltErrorDeg(one, {}), 0.2) << one.posture->name;
    EXPECT_NEAR(std::hypot(one.raw.accel[0], one.raw.accel[1], one.raw.accel[2]), kGravity, 0.03);
    for (const double rate : one.raw.gyro) EXPECT_NEAR(rate, 0, 0.03);
  }
}

TEST(CalibratedImu, ASecondCalibrationFindsTheSameAndNotTheRemainder) {
  const ImuCalibration truth = hiddenBy(8);
  TwinBench first{modelOf(truth, 0.06)};
  const ImuFit fit = fitImu(readAll(first), 0.1, {});
  TwinBench second{modelOf(truth, 0.06), 3, {.offsets = {}, .imu = fit.calibration}};
  const ImuFit again = fitImu(readAll(second, fit.calibration), 0.1, fit.calibration);
  EXPECT_LT(degreesBetween(again.calibration.mounting_rad, truth.mounting_rad), 0.1);
  for (const PostureError& error : again.errors) EXPECT_LT(error.before_deg, 0.2) << error.posture->name;
}

/// Holds one posture whatever is asked for.
struct StubbornHands final : Stand {
  explicit StubbornHands(Stand& clamp) : hands{clamp} {}
  Held hold(const TrunkPosture&) override { return hands.hold(kPostures[0]); }
  Stand& hands;
};

TEST(Postures, AreRefusedIfTheRobotIsHeldOtherwise) {
  TwinBench bench{modelOf({}, 0.06)};
  StubbornHands hands{*bench.stand};
  std::ostringstream log;
  const auto read = readPostures(*bench.link, hands, {}, seconds{1}, kRunning, log);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_THAT(log.str(), testing::HasSubstr(messages::kAnotherPosture));
}

TEST(Postures, AreRefusedWhileTheRobotIsNotAtRest) {
  twin::Model shaking = modelOf({}, 0.06);
  shaking.imu.gyro_noise_rad_s = 0.3;
  TwinBench bench{shaking};
  std::ostringstream log;
  EXPECT_TRUE(readPostures(*bench.link, *bench.stand, {}, seconds{1}, kRunning, log).empty());
  EXPECT_THAT(log.str(), testing::HasSubstr(messages::kMoved));
}

}  // namespace
}  // namespace darwinop::calibrate
