// Python classes of motors and their encoders.
#include <webots/Motor.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Servo.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

namespace {

using namespace webots;
using MotorClass = DeviceClass<Motor, Device>;

template <class Class, class Function>
void sets(Class& type, const char* setter, Function function, const char* argument) {
  type.def(setter, function, py::arg(argument), kQuick);
}

void bindSettings(MotorClass& motor) {
  sets(motor, "setPosition", &Motor::setPosition, "position");
  sets(motor, "setVelocity", &Motor::setVelocity, "velocity");
  sets(motor, "setAcceleration", &Motor::setAcceleration, "acceleration");
  sets(motor, "setAvailableTorque", &Motor::setAvailableTorque, "torque");
  sets(motor, "setAvailableForce", &Motor::setAvailableForce, "force");
  sets(motor, "setTorque", &Motor::setTorque, "torque");
  sets(motor, "setForce", &Motor::setForce, "force");
  motor.def("setControlPID", &Motor::setControlPID, py::arg("p"), py::arg("i"), py::arg("d"), kQuick);
  reads(motor, "getTargetPosition", &Motor::getTargetPosition, "setPosition");
  reads(motor, "getVelocity", &Motor::getVelocity, "setVelocity");
  reads(motor, "getAcceleration", &Motor::getAcceleration, "setAcceleration");
  reads(motor, "getAvailableTorque", &Motor::getAvailableTorque, "setAvailableTorque");
  reads(motor, "getAvailableForce", &Motor::getAvailableForce, "setAvailableForce");
}

void bindProperties(MotorClass& motor) {
  reads(motor, "getMinPosition", &Motor::getMinPosition);
  reads(motor, "getMaxPosition", &Motor::getMaxPosition);
  reads(motor, "getMaxVelocity", &Motor::getMaxVelocity);
  reads(motor, "getMaxTorque", &Motor::getMaxTorque);
  reads(motor, "getMaxForce", &Motor::getMaxForce);
  reads(motor, "getMultiplier", &Motor::getMultiplier);
  reads(motor, "getType", [](const Motor& self) { return static_cast<int>(self.getType()); });
  reads(motor, "getBrake", [](const Motor&) { return py::none(); });
  reads(motor, "getPositionSensor", &Motor::getPositionSensor);
  constants(motor, {{"ROTATIONAL", Motor::ROTATIONAL}, {"LINEAR", Motor::LINEAR}});
}

void bindFeedback(MotorClass& motor) {
  sets(motor, "enableTorqueFeedback", &Motor::enableTorqueFeedback, "sampling_period");
  sets(motor, "enableForceFeedback", &Motor::enableForceFeedback, "sampling_period");
  sets(motor, "enablePosition", &Motor::enablePosition, "sampling_period");
  motor.def("disableTorqueFeedback", &Motor::disableTorqueFeedback, kQuick);
  motor.def("disableForceFeedback", &Motor::disableForceFeedback, kQuick);
  motor.def("disablePosition", &Motor::disablePosition, kQuick);
  reads(motor, "getTorqueFeedback", &Motor::getTorqueFeedback);
  reads(motor, "getForceFeedback", &Motor::getForceFeedback);
  reads(motor, "getTorqueFeedbackSamplingPeriod", &Motor::getTorqueFeedbackSamplingPeriod);
  reads(motor, "getForceFeedbackSamplingPeriod", &Motor::getForceFeedbackSamplingPeriod);
  reads(motor, "getPosition", &Motor::getPosition);
  reads(motor, "getPositionSamplingPeriod", &Motor::getPositionSamplingPeriod);
}

/// The class of 2013.
void bindServo(py::module_& module) {
  DeviceClass<Servo, Motor> servo{module, "Servo", py::dynamic_attr()};
  isMadeByName(servo);
  sets(servo, "setMotorForce", &Servo::setMotorForce, "force");
  sets(servo, "setControlP", &Servo::setControlP, "p");
  sets(servo, "enableMotorForceFeedback", &Servo::enableMotorForceFeedback, "sampling_period");
  servo.def("disableMotorForceFeedback", &Servo::disableMotorForceFeedback, kQuick);
  reads(servo, "getMotorForceFeedback", &Servo::getMotorForceFeedback);
  reads(servo, "getMotorForceFeedbackSamplingPeriod", &Servo::getMotorForceFeedbackSamplingPeriod);
  reads(servo, "getSamplingPeriod", &Servo::getSamplingPeriod);
}

}  // namespace

void bindMotors(py::module_& module) {
  MotorClass motor{module, "Motor", py::dynamic_attr()};
  isMadeByName(motor);
  DeviceClass<PositionSensor, Device> sensor{module, "PositionSensor", py::dynamic_attr()};
  isMadeByName(sensor);

  bindSettings(motor);
  bindProperties(motor);
  bindFeedback(motor);
  bindServo(module);

  isSampled(sensor, &PositionSensor::enable, &PositionSensor::disable, &PositionSensor::getSamplingPeriod);
  reads(sensor, "getValue", &PositionSensor::getValue);
  reads(sensor, "getType", [](const PositionSensor& self) { return static_cast<int>(self.getType()); });
  reads(sensor, "getBrake", [](const PositionSensor&) { return py::none(); });
  reads(sensor, "getMotor", &PositionSensor::getMotor);
  constants(sensor, {{"ROTATIONAL", PositionSensor::ROTATIONAL},
                     {"LINEAR", PositionSensor::LINEAR},
                     {"ANGULAR", PositionSensor::ANGULAR}});
}

}  // namespace darwinop::python
