// The calibration of the inertial sensors: axes, inverse, and what a missing reply must not become.
#include "hal/cm730/imu_correction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/conversions.hpp"
#include "hal/cm730/reply_decoder.hpp"

namespace darwinop::cm730 {
namespace {

using Axes = ImuCalibration::Axes;

ImuCalibration everything() {
  return {.gyro_bias_rad_s = {0.1, -0.2, 0.3},
          .accel_bias_m_s2 = {0.5, -0.4, 0.3},
          .accel_scale = {1.05, 0.95, 1.01},
          .mounting_rad = {0.05, -0.1, 0.2}};
}

void expectNear(const Axes& found, const Axes& wanted) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-12) << "axis " << i;
}

TEST(ImuCorrection, RawReadingsAreItsInverse) {
  const ImuCorrection correction{everything()};
  const Axes any{1, -2, 9};
  expectNear(correction.rawAccelerometer(correction.accelerometer(any)), any);
  expectNear(correction.rawGyro(correction.gyro(any)), any);
}

TEST(ImuCorrection, RemovesBiasThenScaleThenMounting) {
  const ImuCorrection correction{{.gyro_bias_rad_s = {0, 0, 0},
                                  .accel_bias_m_s2 = {1, 0, 0},
                                  .accel_scale = {2, 1, 1},
                                  .mounting_rad = {0, 0, kPi / 2}}};
  // The board is turned to the left by 90 deg: its right is the trunk's forward.
  expectNear(correction.accelerometer({5, 0, 0}), {0, 2, 0});
}

TEST(ImuCorrection, TurnsTheGyroscopeAsTheAccelerometerWithItsOwnAxes) {
  // A board that is pitched about the robot's right: forward leans up.
  const ImuCorrection correction{
      {.gyro_bias_rad_s = {}, .accel_bias_m_s2 = {}, .accel_scale = {1, 1, 1}, .mounting_rad = {kPi / 2, 0, 0}}};
  // Gravity along the board's forward is the trunk's up.
  expectNear(correction.accelerometer({0, 9, 0}), {0, 0, 9});
  // So a turn about the board's forward, which its gyroscope reads as -x (backward), is one about the trunk's up.
  expectNear(correction.gyro({-3, 0, 0}), {0, 0, 3});
  expectNear(correction.gyro({0, 3, 0}), {0, 3, 0});
  expectNear(correction.gyro({0, 0, 3}), {3, 0, 0});  // its up is the trunk's backward
}

TEST(ImuCorrection, WithoutACalibrationReadingsStayTheSameToTheLastBit) {
  BoardReading reading;
  reading.gyro = {RadPerSec{0.1}, RadPerSec{1e-17}, RadPerSec{-0.0}};
  reading.accelerometer = {MeterPerSec2{0.3}, MeterPerSec2{9.7}, MeterPerSec2{1e-300}};
  const BoardReading before = reading;
  ImuCorrection{}.apply(reading);
  EXPECT_EQ(reading.gyro, before.gyro);
  EXPECT_EQ(reading.accelerometer, before.accelerometer);
  EXPECT_TRUE(std::signbit(reading.gyro[2].value));
}

/// A board's block with gyroscope 512 and accelerometer 512, 512, 640, which is 1 g up.
std::vector<std::uint8_t> boardAtRest() {
  return {0x01, 0x00, 0xC0, 0x07, 0xC0, 0x07, 0x00, 0, 0, 0,    0,    0,    0,    0,    0x00,
          0x02, 0x00, 0x02, 0x00, 0x02, 0x00, 0x02, 0, 2, 0x80, 0x02, 0x76, 0x00, 0x02, 0x00};
}

TEST(ImuCorrection, ActsOnEveryReplyOfTheBoardAndOnNothingElse) {
  BusReadings readings{};
  ReplyDecoder decoder{{}, {}, ImuCorrection{everything()}};
  decoder.begin({}, 30, readings);
  EXPECT_FALSE(readings.board.answered);
  EXPECT_FALSE(readings.board.gyro[0].known()) << "missing stays missing";
  const std::vector<std::uint8_t> block = boardAtRest();
  decoder.take(Frame{200, 0, block});
  ASSERT_TRUE(readings.board.answered);
  const Axes wanted = ImuCorrection{everything()}.accelerometer({0, 0, kGravity});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(readings.board.accelerometer[i].value, wanted[i], 1e-9);
  EXPECT_NEAR(readings.board.voltage.value, 11.8, 1e-9);
}

}  // namespace
}  // namespace darwinop::cm730
