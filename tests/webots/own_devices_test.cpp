// Device objects that controllers make, by a class of their own or by new.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <webots/Accelerometer.hpp>
#include <webots/Camera.hpp>
#include <webots/Gyro.hpp>
#include <webots/LED.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Servo.hpp>
#include <webots/Speaker.hpp>
#include <webots/TouchSensor.hpp>

#include "core/counts.hpp"
#include "fixture.hpp"
#include "webots/messages.hpp"

namespace darwinop::webots_api {
namespace {

/// Counts its objects.
class OwnServo : public webots::Servo {
 public:
  explicit OwnServo(const std::string& name) : Servo(name) { ++alive; }
  ~OwnServo() override { --alive; }
  static int alive;
};
int OwnServo::alive = 0;

class OwnGyro : public webots::Gyro {
 public:
  explicit OwnGyro(const std::string& name) : Gyro(name) {}
};

class OwnRobot : public webots::Robot {
 public:
  explicit OwnRobot(RobotImpl* impl) : Robot(impl) {}
  mutable int makes = 0;

 protected:
  webots::Servo* createServo(const std::string& name) const override {
    ++makes;
    return new OwnServo{name};
  }
  webots::Gyro* createGyro(const std::string& name) const override { return new OwnGyro{name}; }
};

using OwnDevices = Facade;

TEST_F(OwnDevices, AGetterReturnsWhatTheMakerOfTheControllerReturnedOnce) {
  {
    const OwnRobot robot{makeImpl()};
    webots::Servo* const neck = robot.getServo("Neck");
    EXPECT_NE(dynamic_cast<OwnServo*>(neck), nullptr);
    EXPECT_EQ(robot.getServo("Neck"), neck);
    EXPECT_EQ(robot.makes, 1);
    EXPECT_NE(robot.getServo("Head"), neck);
    EXPECT_EQ(robot.makes, 2);
    EXPECT_EQ(neck->getName(), "Neck");
    EXPECT_EQ(neck->getTag(), robot.getMotor("Neck")->getTag());
    EXPECT_EQ(OwnServo::alive, 2);
  }
  EXPECT_EQ(OwnServo::alive, 0) << "the robot deletes them";
}

TEST_F(OwnDevices, GetDeviceReturnsThemToo) {
  const OwnRobot robot{makeImpl()};
  EXPECT_NE(dynamic_cast<OwnGyro*>(robot.getDevice("Gyro")), nullptr);
  EXPECT_EQ(robot.getDevice("Gyro"), robot.getGyro("Gyro"));
}

TEST_F(OwnDevices, WithoutAMakerTheGettersReturnTheRobotsOwn) {
  for (int i = 0; i < robot().getNumberOfDevices(); ++i) {
    webots::Device* const device = robot().getDeviceByIndex(i);
    EXPECT_EQ(robot().getDevice(device->getName()), device);
    EXPECT_EQ(device->getTag(), i + 1);
  }
  EXPECT_EQ(robot().getServo("Neck"), robot().getMotor("Neck"));
}

TEST_F(OwnDevices, AServoMadeByNewDrivesTheJoint) {
  robot();
  webots::Servo servo{"Neck"};
  servo.setPosition(0.2);
  EXPECT_NEAR(commanded(Joint::kNeck).goal.value, 0.2, 0.001);
  EXPECT_DOUBLE_EQ(robot().getMotor("Neck")->getTargetPosition(), 0.2);
  servo.setPosition(0.1);
  EXPECT_NEAR(commanded(Joint::kNeck).goal.value, 0.1, 0.001);
}

TEST_F(OwnDevices, SensorsMadeByNewHaveTheValuesOfEachStep) {
  robot();
  const webots::Gyro gyro{"Gyro"};
  const webots::Accelerometer accelerometer{"Accelerometer"};
  const webots::PositionSensor position{"NeckS"};
  const webots::TouchSensor button{"ButtonStart"};
  const webots::Camera camera{"Camera"};
  const double* const rates = gyro.getValues();
  for (int i = 1; i <= 3; ++i) {
    fake.image.board.gyro[0] = RadPerSec{i * kGyroRegister.scale};
    fake.image.board.accelerometer[0] = MeterPerSec2{i * kAccelRegister.scale};
    ASSERT_EQ(robot().step(16), 0);
    EXPECT_EQ(rates[0], 512 + i);
    EXPECT_EQ(accelerometer.getValues()[0], 512 + i);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(rates[axis], robot().getGyro("Gyro")->getValues()[axis]);
      EXPECT_EQ(accelerometer.getValues()[axis], robot().getAccelerometer("Accelerometer")->getValues()[axis]);
    }
    EXPECT_EQ(position.getValue(), robot().getPositionSensor("NeckS")->getValue());
    EXPECT_EQ(button.getValue(), robot().getTouchSensor("ButtonStart")->getValue());
  }
  for (int i = 0; i < 6; ++i) EXPECT_EQ(gyro.getLookupTable()[i], robot().getGyro("Gyro")->getLookupTable()[i]);
  EXPECT_EQ(camera.getWidth(), robot().getCamera("Camera")->getWidth());
}

TEST_F(OwnDevices, AnObjectThatTheControllerDeletesIsForgotten) {
  const OwnRobot robot{makeImpl()};
  delete robot.getServo("Neck");
  EXPECT_EQ(OwnServo::alive, 0);
  EXPECT_NE(robot.getServo("Neck"), nullptr);
  EXPECT_EQ(robot.makes, 2);
}

TEST_F(OwnDevices, AnObjectMayOutliveTheRobot) {
  robot();
  const auto led = std::make_unique<webots::LED>("EyeLed");
  end();
  EXPECT_EQ(led->getName(), "EyeLed");
}

TEST_F(OwnDevices, ADeviceThatTheRobotLacksEndsTheProgram) {
  robot();
  EXPECT_EXIT(webots::Servo{"Nose"}, testing::ExitedWithCode(EXIT_FAILURE),
              testing::HasSubstr(messages::kNoDeviceToMake));
  EXPECT_EXIT(webots::LED{"Neck"}, testing::ExitedWithCode(EXIT_FAILURE),
              testing::HasSubstr(messages::kNoDeviceToMake));
  end();
  EXPECT_EXIT(webots::Servo{"Neck"}, testing::ExitedWithCode(EXIT_FAILURE), testing::HasSubstr(messages::kNoRobotYet));
}

TEST_F(OwnDevices, TheControllersNameAndArgumentsAreThoseOfTheProgram) {
  EXPECT_EQ(robot().getControllerName(), "webots_test");
  std::ifstream command{"/proc/self/cmdline"};
  std::string word, arguments;
  std::getline(command, word, '\0');  // the program
  while (std::getline(command, word, '\0')) arguments += (arguments.empty() ? "" : " ") + word;
  EXPECT_EQ(robot().getControllerArguments(), arguments);
}

}  // namespace
}  // namespace darwinop::webots_api
