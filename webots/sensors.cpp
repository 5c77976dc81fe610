// Sensors: encoders, accelerometer, gyroscope, buttons.
#include "core/counts.hpp"
#include "webots/Accelerometer.hpp"
#include "webots/Gyro.hpp"
#include "webots/Motor.hpp"
#include "webots/Node.hpp"
#include "webots/PositionSensor.hpp"
#include "webots/TouchSensor.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace webots {

namespace webots_api = darwinop::webots_api;

namespace {
// Lookup table of 2013, range 0..1024 about 512. Both rows: SI value, count, noise.
void fillLookup(double (&table)[6], const darwinop::Register& law) {
  for (int row = 0; row < 2; ++row) {
    const double count = 1024.0 * row;
    table[3 * row] = (count - law.zero) * law.scale;
    table[3 * row + 1] = count;
    table[3 * row + 2] = 0;
  }
}
}  // namespace

PositionSensor::PositionSensor(const std::string& name, webots_api::RobotImpl& robot, unsigned joint)
    : Device(name, Node::POSITION_SENSOR, robot), joint_(joint), period_(0) {}

PositionSensor::~PositionSensor() = default;
void PositionSensor::enable(int sampling_period) {
  period_ = sampling_period;
}
void PositionSensor::disable() {
  period_ = 0;
}

double PositionSensor::getValue() const {
  const auto* seen = robot_.joint(static_cast<darwinop::Joint>(joint_), getName());
  return seen ? seen->position.value : darwinop::kUnknown;
}

Motor* PositionSensor::getMotor() const {
  return dynamic_cast<Motor*>(robot_.find(std::string{darwinop::kJointTable[joint_].name}));
}

Accelerometer::Accelerometer(const std::string& name, webots_api::RobotImpl& robot)
    : Device(name, Node::ACCELEROMETER, robot), values_(), lookup_(), period_(0) {
  fillLookup(lookup_, darwinop::kAccelRegister);
}

Accelerometer::~Accelerometer() = default;
void Accelerometer::enable(int sampling_period) {
  period_ = sampling_period;
}
void Accelerometer::disable() {
  period_ = 0;
}

const double* Accelerometer::getValues() const {
  static_cast<void>(robot_.board(getName()));  // warns once if the values are too old
  return values_;
}

void Accelerometer::refresh() {
  const darwinop::BoardSensors* const board = robot_.usableBoard();
  for (std::size_t axis = 0; axis < 3; ++axis)
    values_[axis] =
        darwinop::countFrom(board ? board->accelerometer[axis].value : darwinop::kUnknown, darwinop::kAccelRegister);
}

Gyro::Gyro(const std::string& name, webots_api::RobotImpl& robot)
    : Device(name, Node::GYRO, robot), values_(), lookup_(), period_(0) {
  fillLookup(lookup_, darwinop::kGyroRegister);
}

Gyro::~Gyro() = default;
void Gyro::enable(int sampling_period) {
  period_ = sampling_period;
}
void Gyro::disable() {
  period_ = 0;
}

const double* Gyro::getValues() const {
  static_cast<void>(robot_.board(getName()));  // warns once if the values are too old
  return values_;
}

void Gyro::refresh() {
  const darwinop::BoardSensors* const board = robot_.usableBoard();
  for (std::size_t axis = 0; axis < 3; ++axis)
    values_[axis] = darwinop::countFrom(board ? board->gyro[axis].value : darwinop::kUnknown, darwinop::kGyroRegister);
}

TouchSensor::TouchSensor(const std::string& name, webots_api::RobotImpl& robot, int bit)
    : Device(name, Node::TOUCH_SENSOR, robot), bit_(bit), period_(0) {}

TouchSensor::~TouchSensor() = default;
void TouchSensor::enable(int sampling_period) {
  period_ = sampling_period;
}
void TouchSensor::disable() {
  period_ = 0;
}

const double* TouchSensor::getValues() const {
  webots_api::warnOnce(webots_api::messages::kNoThreeAxes);
  return nullptr;
}

double TouchSensor::getValue() const {
  const auto* board = robot_.board(getName());
  return board != nullptr && board->buttons_known ? ((board->buttons & bit_) != 0 ? 1.0 : 0.0) : darwinop::kUnknown;
}

}  // namespace webots
