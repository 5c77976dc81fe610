// Python class for webots::Robot; apps/python/controller/robot.py completes it.
#include <webots/Accelerometer.hpp>
#include <webots/Camera.hpp>
#include <webots/Gyro.hpp>
#include <webots/Joystick.hpp>
#include <webots/Keyboard.hpp>
#include <webots/LED.hpp>
#include <webots/Mouse.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Robot.hpp>
#include <webots/Servo.hpp>
#include <webots/Speaker.hpp>
#include <webots/TouchSensor.hpp>

#include "apps/python/bindings.hpp"
#include "apps/python/interrupt.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"
#include "webots/stop_signals.hpp"

namespace darwinop::python {

namespace {

using webots::Robot;

/// Connects without ending the process on failure: Python has output to flush and files to close.
class PythonRobot : public Robot {
 public:
  PythonRobot() : Robot{webots_api::connectOrThrow()} { installInterrupt(); }
};

/// SystemExit after a failure, whose reason is logged.
std::unique_ptr<PythonRobot> connect() {
  const auto turn = takeTurn();
  try {
    const py::gil_scoped_release others_run;
    return std::make_unique<PythonRobot>();
  } catch (const std::exception& error) {
    webots_api::logLine(error.what());
  }
  PyErr_SetObject(PyExc_SystemExit, py::int_{EXIT_FAILURE}.ptr());
  throw py::error_already_set();
}

template <class Class, class Function>
void finds(Class& type, const char* getter, Function function) {
  type.def(getter, function, py::arg("name"), kQuick, py::return_value_policy::reference);
}

template <class Class>
void bindDeviceGetters(Class& robot) {
  finds(robot, "getDevice", &Robot::getDevice);
  finds(robot, "getAccelerometer", &Robot::getAccelerometer);
  finds(robot, "getCamera", &Robot::getCamera);
  finds(robot, "getGyro", &Robot::getGyro);
  finds(robot, "getLED", &Robot::getLED);
  finds(robot, "getMotor", &Robot::getMotor);
  finds(robot, "getPositionSensor", &Robot::getPositionSensor);
  finds(robot, "getServo", &Robot::getServo);
  finds(robot, "getSpeaker", &Robot::getSpeaker);
  finds(robot, "getTouchSensor", &Robot::getTouchSensor);
  robot.def("getDeviceByIndex", &Robot::getDeviceByIndex, py::arg("index"), kQuick, py::return_value_policy::reference);
  reads(robot, "getNumberOfDevices", &Robot::getNumberOfDevices);
  reads(robot, "getKeyboard", &Robot::getKeyboard);
  reads(robot, "getJoystick", &Robot::getJoystick);
  reads(robot, "getMouse", &Robot::getMouse);
}

template <class Class>
void bindBattery(Class& robot) {
  robot.def("batterySensorEnable", &Robot::batterySensorEnable, py::arg("sampling_period"), kQuick);
  robot.def("batterySensorDisable", &Robot::batterySensorDisable, kQuick);
  robot.def("batterySensorGetSamplingPeriod", &Robot::batterySensorGetSamplingPeriod, kQuick);
  robot.def("batterySensorGetValue", &Robot::batterySensorGetValue, kQuick);
}

template <class Class>
void bindSimulatorOnly(Class& robot) {
  reads(robot, "getWorldPath", &Robot::getWorldPath);
  reads(robot, "getSupervisor", &Robot::getSupervisor);
  reads(robot, "getSynchronization", &Robot::getSynchronization);
  robot.def("getUrdf", &Robot::getUrdf, py::arg("prefix") = "", kQuick);
  robot.def(
      "setMode",
      [](Robot& self, int mode, const std::string& arg) { self.setMode(static_cast<Robot::Mode>(mode), arg.c_str()); },
      py::arg("mode"), py::arg("arg") = "", kQuick);
  robot.def(
      "waitForUserInputEvent",
      [](Robot& self, int type, int timeout) {
        return static_cast<int>(self.waitForUserInputEvent(static_cast<Robot::UserInputEvent>(type), timeout));
      },
      py::arg("event_type"), py::arg("timeout"), kQuick);
  robot.def("wwiSendText", &Robot::wwiSendText, py::arg("text"), kQuick);
  robot.def(
      "windowCustomFunction", [](Robot& self, const py::object&) { self.windowCustomFunction(nullptr); },
      py::arg("arg") = py::none(), kQuick);
  robot.def("wwiReceiveText", &Robot::wwiReceiveText, kQuick);
}

void bindConstants(const py::handle& robot) {
  constants(robot, {{"MODE_SIMULATION", Robot::MODE_SIMULATION},
                    {"MODE_CROSS_COMPILATION", Robot::MODE_CROSS_COMPILATION},
                    {"MODE_REMOTE_CONTROL", Robot::MODE_REMOTE_CONTROL},
                    {"EVENT_QUIT", Robot::EVENT_QUIT},
                    {"EVENT_NO_EVENT", Robot::EVENT_NO_EVENT},
                    {"EVENT_MOUSE_CLICK", Robot::EVENT_MOUSE_CLICK},
                    {"EVENT_MOUSE_MOVE", Robot::EVENT_MOUSE_MOVE},
                    {"EVENT_KEYBOARD", Robot::EVENT_KEYBOARD},
                    {"EVENT_JOYSTICK_BUTTON", Robot::EVENT_JOYSTICK_BUTTON},
                    {"EVENT_JOYSTICK_AXIS", Robot::EVENT_JOYSTICK_AXIS},
                    {"EVENT_JOYSTICK_POV", Robot::EVENT_JOYSTICK_POV}});
}

}  // namespace

webots::Device& deviceOfRobot(const std::string& name) {
  if (auto* const device = webots_api::currentRobot()->find(name)) return *device;  // ApiCall has checked the robot
  throw py::value_error{name + webots_api::messages::kNoDeviceToMake};
}

void bindRobot(py::module_& module) {
  py::class_<Robot> robot{module, "Robot", py::dynamic_attr()};
  py::class_<PythonRobot, Robot> connected{module, "ConnectedRobot", py::dynamic_attr()};
  connected.def(py::init(&connect));

  robot.def("step", &Robot::step, py::arg("duration"), kWaiting);
  robot.def("stepBegin", &Robot::stepBegin, py::arg("duration"), kWaiting);
  robot.def("stepEnd", &Robot::stepEnd, kWaiting);
  reads(robot, "getName", &Robot::getName);
  reads(robot, "getModel", &Robot::getModel);
  reads(robot, "getTime", &Robot::getTime);
  reads(robot, "getMode", [](const Robot& self) { return static_cast<int>(self.getMode()); });
  reads(robot, "getType", &Robot::getType);
  reads(robot, "getBasicTimeStep", &Robot::getBasicTimeStep);
  reads(robot, "getProjectPath", &Robot::getProjectPath);
  for (const char* name : {"setCustomData", "setData"}) robot.def(name, &Robot::setCustomData, py::arg("data"), kQuick);
  reads(robot, "getCustomData", &Robot::getCustomData, "setCustomData");
  robot.def("getData", &Robot::getData, kQuick);
  robot.def("keyboardEnable", &Robot::keyboardEnable, py::arg("sampling_period"), kWaiting);
  robot.def("keyboardDisable", &Robot::keyboardDisable, kWaiting);
  robot.def("keyboardGetKey", &Robot::keyboardGetKey, kQuick);
  bindDeviceGetters(robot);
  bindBattery(robot);
  bindSimulatorOnly(robot);
  bindConstants(robot);

  module.def("end_session", &endSession);
  module.def("stop_requested", [] { return webots_api::stopRequested().load(); });
  module.def("set_program_directory", &webots_api::setProgramDirectory, py::arg("directory"));
}

}  // namespace darwinop::python
