// Table of the robot's devices, in the order of getDeviceByIndex(), with the names of getDevice().
#include <vector>

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

/// Servos alone on an adapter: what only a board has does not exist, as on a robot of the simulator without it.
void RobotImpl::removeDevicesOfBoard() {
  std::erase_if(devices_, [this](const auto& device) {
    const webots::Device* const one = device.get();
    const bool of_board = dynamic_cast<const webots::Accelerometer*>(one) != nullptr ||
                          dynamic_cast<const webots::Gyro*>(one) != nullptr ||
                          dynamic_cast<const webots::LED*>(one) != nullptr ||
                          dynamic_cast<const webots::TouchSensor*>(one) != nullptr;
    if (of_board) by_name_.erase(one->getName());
    return of_board;
  });
}

}  // namespace darwinop::webots_api
