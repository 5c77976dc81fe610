// Table of the robot's devices, in the order of getDeviceByIndex(), with the names of getDevice().
#include "webots/Accelerometer.hpp"
#include "webots/Camera.hpp"
#include "webots/Gyro.hpp"
#include "webots/LED.hpp"
#include "webots/PositionSensor.hpp"
#include "webots/Servo.hpp"
#include "webots/Speaker.hpp"
#include "webots/TouchSensor.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::webots_api {

void RobotImpl::addDevices() {
  for (const JointRow& row : kJointTable) {
    const std::string name{row.name};
    goals::MotorControl& control = motors_.emplace_back(static_cast<Joint>(row.id - 1));
    add(new webots::Servo(name, *this, control));
    add(new webots::PositionSensor(name + "S", *this, row.id - 1U));
  }
  add(new webots::Accelerometer("Accelerometer", *this));
  add(new webots::Gyro("Gyro", *this));
  add(new webots::Camera("Camera", *this, config_.camera_width, config_.camera_height));
  add(new webots::LED("EyeLed", *this, webots::LED::EYE, 0));
  add(new webots::LED("HeadLed", *this, webots::LED::HEAD, 0));
  add(new webots::LED("BackLedRed", *this, webots::LED::BACK, 1));
  add(new webots::LED("BackLedBlue", *this, webots::LED::BACK, 2));
  add(new webots::LED("BackLedGreen", *this, webots::LED::BACK, 4));
  add(new webots::Speaker("Speaker", *this));
  add(new webots::TouchSensor("ButtonMode", *this, 1));
  add(new webots::TouchSensor("ButtonStart", *this, 2));
}

}  // namespace darwinop::webots_api
