// Inertial sensors in raw counts, buttons, battery.
#include <gmock/gmock.h>

#include <cmath>
#include <webots/Accelerometer.hpp>
#include <webots/Gyro.hpp>
#include <webots/LED.hpp>
#include <webots/TouchSensor.hpp>

#include "core/counts.hpp"
#include "fixture.hpp"

namespace darwinop::webots_api {
namespace {

class SensorTest : public Facade {};

TEST_F(SensorTest, ARobotAtRestReads512And640) {
  const double* gyro = robot().getGyro("Gyro")->getValues();
  const double* accelerometer = robot().getAccelerometer("Accelerometer")->getValues();
  EXPECT_EQ(std::vector<double>(gyro, gyro + 3), (std::vector<double>{512, 512, 512}));
  EXPECT_EQ(std::vector<double>(accelerometer, accelerometer + 3), (std::vector<double>{512, 512, 640}));
}

TEST_F(SensorTest, TheAxesAreNotMixedUp) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fake.image.board.gyro[axis] = RadPerSec{static_cast<double>(axis + 1) * kGyroRegister.scale};
    fake.image.board.accelerometer[axis] = MeterPerSec2{-static_cast<double>(axis + 1) * kAccelRegister.scale};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(robot().getGyro("Gyro")->getValues()[axis], 513 + static_cast<double>(axis));
    EXPECT_EQ(robot().getAccelerometer("Accelerometer")->getValues()[axis], 511 - static_cast<double>(axis));
  }
}

TEST_F(SensorTest, AKeptPointerSeesEveryStep) {
  const double* values = robot().getGyro("Gyro")->getValues();
  fake.image.board.gyro[0] = RadPerSec{100 * kGyroRegister.scale};
  EXPECT_EQ(values[0], 512);
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_EQ(values[0], 612);
}

TEST_F(SensorTest, ABoardThatIsSilentReadsNaNEverywhere) {
  robot();
  fake.image.board.motion.age = 4;
  EXPECT_EQ(robot().step(16), 0);
  testing::internal::CaptureStderr();
  EXPECT_TRUE(std::isnan(robot().getGyro("Gyro")->getValues()[2]));
  EXPECT_TRUE(std::isnan(robot().getAccelerometer("Accelerometer")->getValues()[2]));
  EXPECT_TRUE(std::isnan(robot().getTouchSensor("ButtonMode")->getValue()));
  EXPECT_TRUE(std::isnan(robot().batterySensorGetValue()));
  const std::string said = testing::internal::GetCapturedStderr();
  for (const char* device : {"Gyro has", "Accelerometer has", "ButtonMode has", "the battery sensor has"})
    EXPECT_THAT(said, testing::HasSubstr(device));
}

TEST_F(SensorTest, WithoutABoardItsDevicesDoNotExist) {
  fake.image.board = {};
  fake.image.board.absent = true;
  EXPECT_EQ(robot().getGyro("Gyro"), nullptr);
  EXPECT_EQ(robot().getAccelerometer("Accelerometer"), nullptr);
  for (const char* led : {"EyeLed", "HeadLed", "BackLedRed", "BackLedBlue", "BackLedGreen"}) {
    EXPECT_EQ(robot().getLED(led), nullptr) << led;
    EXPECT_EQ(robot().getDevice(led), nullptr) << led;
  }
  EXPECT_EQ(robot().getTouchSensor("ButtonMode"), nullptr);
  EXPECT_EQ(robot().getTouchSensor("ButtonStart"), nullptr);
  EXPECT_TRUE(std::isnan(robot().batterySensorGetValue()));
  const int left = 2 * static_cast<int>(kJoints) + 2;  // motors, their sensors, camera, speaker
  EXPECT_EQ(robot().getNumberOfDevices(), left);
  for (int i = 0; i < left; ++i) EXPECT_NE(robot().getDeviceByIndex(i), nullptr) << i;
  EXPECT_EQ(robot().step(16), 0);
}

TEST_F(SensorTest, ButtonsAreTheBoardsBits) {
  fake.image.board.buttons = 2;
  EXPECT_EQ(robot().getTouchSensor("ButtonMode")->getValue(), 0);
  EXPECT_EQ(robot().getTouchSensor("ButtonStart")->getValue(), 1);
}

TEST_F(SensorTest, AButtonThatIsNotReportedIsNaN) {
  fake.image.board.buttons_known = false;
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_TRUE(std::isnan(robot().getTouchSensor("ButtonStart")->getValue()));
  EXPECT_EQ(robot().batterySensorGetValue(), 11.8) << "the board answers all the same";
}

TEST_F(SensorTest, TheLookupTableIsTheLawOfTheCounts) {
  const webots::Accelerometer& device = *robot().getAccelerometer("Accelerometer");
  ASSERT_EQ(device.getLookupTableSize(), 2);
  const double* table = device.getLookupTable();
  const double slope = (table[4] - table[1]) / (table[3] - table[0]);
  EXPECT_NEAR(table[1] + (9.80665 - table[0]) * slope, 640, 1e-9);
}

TEST_F(SensorTest, SamplingPeriodsAreKeptAsGiven) {
  webots::Gyro& gyro = *robot().getGyro("Gyro");
  EXPECT_EQ(gyro.getSamplingPeriod(), 0);
  gyro.enable(32);
  EXPECT_EQ(gyro.getSamplingPeriod(), 32);
  gyro.disable();
  EXPECT_EQ(gyro.getSamplingPeriod(), 0);
  robot().batterySensorEnable(100);
  EXPECT_EQ(robot().batterySensorGetSamplingPeriod(), 100);
}

}  // namespace
}  // namespace darwinop::webots_api
