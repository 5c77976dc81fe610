// Python class of the keyboard.
#include <webots/Keyboard.hpp>
#include <webots/Robot.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

using webots::Keyboard;

void bindKeyboard(py::module_& module) {
  DeviceClass<Keyboard> keyboard{module, "Keyboard", py::dynamic_attr()};
  // Keyboard() is the robot's keyboard, as upstream.
  keyboard.def(py::init([] {
    const ApiCall call;
    return webots::Robot::getInstance()->getKeyboard();
  }));
  isSampled(keyboard, &Keyboard::enable, &Keyboard::disable, &Keyboard::getSamplingPeriod);
  reads(keyboard, "getKey", &Keyboard::getKey);
  constants(keyboard, {{"END", Keyboard::END},
                       {"HOME", Keyboard::HOME},
                       {"LEFT", Keyboard::LEFT},
                       {"UP", Keyboard::UP},
                       {"RIGHT", Keyboard::RIGHT},
                       {"DOWN", Keyboard::DOWN},
                       {"PAGEUP", Keyboard::PAGEUP},
                       {"PAGEDOWN", Keyboard::PAGEDOWN},
                       {"NUMPAD_HOME", Keyboard::NUMPAD_HOME},
                       {"NUMPAD_LEFT", Keyboard::NUMPAD_LEFT},
                       {"NUMPAD_UP", Keyboard::NUMPAD_UP},
                       {"NUMPAD_RIGHT", Keyboard::NUMPAD_RIGHT},
                       {"NUMPAD_DOWN", Keyboard::NUMPAD_DOWN},
                       {"NUMPAD_END", Keyboard::NUMPAD_END},
                       {"KEY", Keyboard::KEY},
                       {"SHIFT", Keyboard::SHIFT},
                       {"CONTROL", Keyboard::CONTROL},
                       {"ALT", Keyboard::ALT}});
}

}  // namespace darwinop::python
