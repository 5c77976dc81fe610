// Python classes of the person's joystick and mouse, which this robot does not read.
#include <webots/Joystick.hpp>
#include <webots/Mouse.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

namespace {

using webots::Joystick;
using webots::Mouse;
using webots::MouseState;

void bindJoystick(py::module_& module) {
  OwnedClass<Joystick> joystick{module, "Joystick", py::dynamic_attr()};
  joystick.def(py::init<>(), kQuick);
  isSampled(joystick, &Joystick::enable, &Joystick::disable, &Joystick::getSamplingPeriod);
  joystick.def("isConnected", &Joystick::isConnected, kQuick);
  reads(joystick, "getModel", &Joystick::getModel);
  reads(joystick, "getNumberOfAxes", &Joystick::getNumberOfAxes);
  joystick.def("getAxisValue", &Joystick::getAxisValue, py::arg("axis"), kQuick);
  reads(joystick, "getNumberOfPovs", &Joystick::getNumberOfPovs);
  joystick.def("getPovValue", &Joystick::getPovValue, py::arg("pov"), kQuick);
  reads(joystick, "getPressedButton", &Joystick::getPressedButton);
  joystick.def("setConstantForce", &Joystick::setConstantForce, py::arg("level"), kQuick);
  joystick.def("setConstantForceDuration", &Joystick::setConstantForceDuration, py::arg("duration"), kQuick);
  joystick.def("setAutoCenteringGain", &Joystick::setAutoCenteringGain, py::arg("gain"), kQuick);
  joystick.def("setResistanceGain", &Joystick::setResistanceGain, py::arg("gain"), kQuick);
  joystick.def("setForceAxis", &Joystick::setForceAxis, py::arg("axis"), kQuick);
}

void bindMouse(py::module_& module) {
  py::class_<MouseState> state{module, "MouseState"};
  state.def_readonly("left", &MouseState::left);
  state.def_readonly("middle", &MouseState::middle);
  state.def_readonly("right", &MouseState::right);
  for (const auto& [name, coordinate] :
       {std::pair{"u", &MouseState::u}, std::pair{"v", &MouseState::v}, std::pair{"x", &MouseState::x},
        std::pair{"y", &MouseState::y}, std::pair{"z", &MouseState::z}})
    state.def_readonly(name, coordinate);

  OwnedClass<Mouse> mouse{module, "Mouse", py::dynamic_attr()};
  mouse.def(py::init<>(), kQuick);
  isSampled(mouse, &Mouse::enable, &Mouse::disable, &Mouse::getSamplingPeriod);
  mouse.def("enable3dPosition", &Mouse::enable3dPosition, kQuick);
  mouse.def("disable3dPosition", &Mouse::disable3dPosition, kQuick);
  mouse.def("is3dPositionEnabled", &Mouse::is3dPositionEnabled, kQuick);
  reads(mouse, "getState", &Mouse::getState);
}

}  // namespace

void bindPointers(py::module_& module) {
  bindJoystick(module);
  bindMouse(module);
}

}  // namespace darwinop::python
