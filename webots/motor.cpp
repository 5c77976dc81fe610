// webots::Motor, and webots::Servo, its name of 2013.
#include "webots/Motor.hpp"

#include <string>

#include "webots/Node.hpp"
#include "webots/PositionSensor.hpp"
#include "webots/Servo.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace webots {

using darwinop::webots_api::warnOnce;

namespace {

/// False, with a warning: the value before stays in force. A joint that does not answer has a position of NaN.
bool isNumber(double value, const char* call, const Motor& motor) {
  if (value == value) return true;
  warnOnce(std::string{call} + "(NaN) of " + motor.getName() + " is ignored");
  return false;
}

}  // namespace

Motor::Motor(const std::string& name, darwinop::webots_api::RobotImpl& robot, darwinop::goals::MotorControl& control)
    : Device(name, Node::ROTATIONAL_MOTOR, robot), control_(control), torque_period_(0), position_period_(0) {}

Motor::~Motor() = default;

void Motor::setPosition(double position) {
  if (isNumber(position, "setPosition", *this)) control_.setPosition(position);
}

double Motor::getTargetPosition() const {
  if (control_.position()) return *control_.position();
  const darwinop::JointRow& joint = control_.joint();
  const darwinop::Rad held = robot_.lastKnown(static_cast<darwinop::Joint>(joint.id - 1)).commanded;
  return held.known() ? held.value : darwinop::radFromTicks(joint.start).value;
}

void Motor::setVelocity(double velocity) {
  if (isNumber(velocity, "setVelocity", *this)) control_.setVelocity(velocity);
}
void Motor::setAcceleration(double acceleration) {
  if (isNumber(acceleration, "setAcceleration", *this)) control_.setAcceleration(acceleration);
}
void Motor::setAvailableTorque(double torque) {
  if (isNumber(torque, "setAvailableTorque", *this)) control_.setAvailableTorque(torque);
}
void Motor::setAvailableForce(double force) {
  setAvailableTorque(force);
}
void Motor::setForce(double force) {
  setTorque(force);
}

void Motor::setTorque(double torque) {
  if (isNumber(torque, "setTorque", *this)) control_.setTorque(torque);
}

void Motor::setControlPID(double p, double i, double d) {
  if (i != 0 || d != 0)
    warnOnce("setControlPID() of " + getName() + ": i and d have no effect on this robot, only p has");
  if (!isNumber(p, "setControlPID", *this)) return;
  if (p < 0) return warnOnce("setControlPID() of " + getName() + ": a negative p is ignored");
  if (p < 3 && !robot_.is_tool)
    warnOnce("setControlPID() of " + getName() + ": with p under 3 the motor may not reach its goal");
  control_.setPGain(p);
}

double Motor::getVelocity() const {
  return control_.velocity();
}
double Motor::getMaxVelocity() const {
  return darwinop::kMaxVelocity;
}
double Motor::getAcceleration() const {
  return control_.acceleration();
}
double Motor::getAvailableTorque() const {
  return control_.availableTorque();
}
double Motor::getAvailableForce() const {
  return control_.availableTorque();
}
double Motor::getMaxTorque() const {
  return darwinop::kMaxTorqueNm;
}
double Motor::getMaxForce() const {
  return darwinop::kMaxTorqueNm;
}
double Motor::getMultiplier() const {
  return 1;
}
double Motor::getMinPosition() const {
  return control_.low();
}
double Motor::getMaxPosition() const {
  return control_.high();
}

PositionSensor* Motor::getPositionSensor() const {
  return dynamic_cast<PositionSensor*>(robot_.find(getName() + "S"));
}

void Motor::enableTorqueFeedback(int sampling_period) {
  torque_period_ = sampling_period;
}
void Motor::disableTorqueFeedback() {
  torque_period_ = 0;
}
void Motor::enableForceFeedback(int sampling_period) {
  enableTorqueFeedback(sampling_period);
}
void Motor::disableForceFeedback() {
  disableTorqueFeedback();
}
double Motor::getForceFeedback() const {
  return getTorqueFeedback();
}

double Motor::getTorqueFeedback() const {
  const auto* seen = robot_.joint(static_cast<darwinop::Joint>(control_.joint().id - 1), getName());
  // Sign as in 2013: clockwise positive, as in setTorque().
  return seen ? -seen->load * darwinop::kMaxTorqueNm : darwinop::kUnknown;
}

void Motor::enablePosition(int sampling_period) {
  position_period_ = sampling_period;
}
void Motor::disablePosition() {
  position_period_ = 0;
}

double Motor::getPosition() const {
  const auto* seen = robot_.joint(static_cast<darwinop::Joint>(control_.joint().id - 1), getName());
  return seen ? seen->position.value : darwinop::kUnknown;
}

Servo::Servo(const std::string& name, darwinop::webots_api::RobotImpl& robot, darwinop::goals::MotorControl& control)
    : Motor(name, robot, control) {}

Servo::~Servo() = default;

void Servo::setMotorForce(double force) {
  setAvailableTorque(force);
}
void Servo::setControlP(double p) {
  setControlPID(p, 0, 0);
}
void Servo::enableMotorForceFeedback(int sampling_period) {
  enableTorqueFeedback(sampling_period);
}
void Servo::disableMotorForceFeedback() {
  disableTorqueFeedback();
}
double Servo::getMotorForceFeedback() const {
  return getTorqueFeedback();
}

}  // namespace webots
