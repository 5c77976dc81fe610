// The extension _darwinop: the classes of the packages `controller` and `managers`.
#include "apps/python/bindings.hpp"

PYBIND11_MODULE(_darwinop, module) {
  using namespace darwinop::python;
  module.doc() = "The Webots API and the managers of darwinop-rt. Import controller and managers instead.";
  bindProperties(module);
  bindScene(module);
  bindDevices(module);
  bindMotors(module);
  bindCamera(module);
  bindKeyboard(module);
  bindPointers(module);
  bindSpeaker(module);
  bindRobot(module);
  bindMotion(module);
  bindManagers(module);
}
