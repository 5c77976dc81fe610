// What each file of this folder adds to the extension, and how classes are described.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <utility>
#include <webots/Device.hpp>

#include "apps/python/messages.hpp"
#include "apps/python/session.hpp"

namespace darwinop::python {

namespace py = pybind11;

/// A device belongs to the robot: Python never deletes it. Attributes can be added to it, as to any Python object.
template <class Device, class... Bases>
using DeviceClass = py::class_<Device, Bases..., std::unique_ptr<Device, py::nodelete>>;

/// Deletes when no other thread is inside of a call: step() advances motions and managers.
struct DeleteInTurn {
  template <class Object>
  void operator()(Object* object) const {
    const auto turn = takeTurn();
    delete object;
  }
};
template <class Object, class... Bases>
using OwnedClass = py::class_<Object, Bases..., std::unique_ptr<Object, DeleteInTurn>>;

/// Adds a property for a getter, under both spellings: "getMinPosition" gives min_position and minPosition. Assigning
/// to it on an object hides it there; with `setter`, a method of the class, it calls that.
void addProperty(const py::handle& type, const std::string& getter, const char* setter = nullptr);

/// A method without arguments that returns a value, and its property.
template <class Class, class Function>
void reads(Class& type, const char* getter, Function function, const char* setter = nullptr) {
  type.def(getter, function, kQuick, py::return_value_policy::reference);
  addProperty(type, getter, setter);
}

/// The three methods of what is sampled, and its property.
template <class Class, class Device>
void isSampled(Class& type, void (Device::*enable)(int), void (Device::*disable)(), int (Device::*period)() const) {
  type.def("enable", enable, py::arg("sampling_period"), kWaiting);
  type.def("disable", disable, kWaiting);
  reads(type, "getSamplingPeriod", period);
}

/// The robot's device of this name; ValueError in Python if it has none.
webots::Device& deviceOfRobot(const std::string& name);

/// `Motor("Neck")`: the robot's device of this name, as in the simulator.
template <class Class>
void isMadeByName(Class& type) {
  type.def(py::init([](const std::string& name) {
             auto* const device = dynamic_cast<typename Class::type*>(&deviceOfRobot(name));
             if (device == nullptr) throw py::value_error{name + messages::kOfAnotherClass};
             return device;
           }),
           py::arg("name"), kQuick);
}

/// Constants of a class, as plain numbers.
inline void constants(const py::handle& type, std::initializer_list<std::pair<const char*, int>> values) {
  for (const auto& [name, value] : values) type.attr(name) = value;
}

void bindProperties(py::module_& module);  // first
void bindRobot(py::module_& module);
void bindScene(py::module_& module);    // Node, Field, Proto
void bindDevices(py::module_& module);  // Device, LED, TouchSensor, Accelerometer, Gyro; before those below
void bindMotors(py::module_& module);
void bindCamera(py::module_& module);
void bindKeyboard(py::module_& module);
void bindPointers(py::module_& module);  // Joystick, Mouse
void bindSpeaker(py::module_& module);
void bindMotion(py::module_& module);
void bindManagers(py::module_& module);
void bindVision(py::module_& module);  // called by bindManagers()

}  // namespace darwinop::python
