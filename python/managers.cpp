// Python classes of the managers, under the names of today and of 2013.
#include <DARwInOPDirectoryManager.hpp>
#include <RobotisOp2DirectoryManager.hpp>
#include <RobotisOp2GaitManager.hpp>
#include <RobotisOp2MotionManager.hpp>
#include <RobotisOp2MotionTimerManager.hpp>
#include <RobotisOp2VisionManager.hpp>
#include <webots/Robot.hpp>

#include "python/bindings.hpp"

namespace darwinop::python {

namespace {

using namespace ::managers;

void bindGait(py::module_& module) {
  using Gait = DARwInOPGaitManager;
  OwnedClass<Gait> gait{module, "DARwInOPGaitManager", py::dynamic_attr()};
  gait.def(py::init<webots::Robot*, const std::string&>(), py::arg("robot"), py::arg("iniFilename"),
           py::keep_alive<1, 2>(), kQuick);
  gait.def("isCorrectlyInitialized", &Gait::isCorrectlyInitialized, kQuick);
  gait.def("setXAmplitude", &Gait::setXAmplitude, py::arg("x"), kQuick);
  gait.def("setYAmplitude", &Gait::setYAmplitude, py::arg("y"), kQuick);
  gait.def("setAAmplitude", &Gait::setAAmplitude, py::arg("a"), kQuick);
  gait.def("setMoveAimOn", &Gait::setMoveAimOn, py::arg("on"), kQuick);
  gait.def("setBalanceEnable", &Gait::setBalanceEnable, py::arg("on"), kQuick);
  gait.def("start", &Gait::start, kQuick);
  gait.def("step", &Gait::step, py::arg("ms"), kQuick);
  gait.def("stop", &Gait::stop, kWaiting);
  OwnedClass<RobotisOp2GaitManager, Gait>{module, "RobotisOp2GaitManager", py::dynamic_attr()}.def(
      py::init<webots::Robot*, const std::string&>(), py::arg("robot"), py::arg("iniFilename"), py::keep_alive<1, 2>(),
      kQuick);
}

void bindMotionPages(py::module_& module) {
  using Pages = DARwInOPMotionManager;
  OwnedClass<Pages> pages{module, "DARwInOPMotionManager", py::dynamic_attr()};
  pages.def(py::init<webots::Robot*, const std::string&>(), py::arg("robot"), py::arg("customMotionFile") = "",
            py::keep_alive<1, 2>(), kQuick);
  pages.def("isCorrectlyInitialized", &Pages::isCorrectlyInitialized, kQuick);
  pages.def("playPage", &Pages::playPage, py::arg("id"), py::arg("sync") = true, kWaiting);
  pages.def("step", &Pages::step, py::arg("ms"), kQuick);
  pages.def("isMotionPlaying", &Pages::isMotionPlaying, kQuick);
  OwnedClass<RobotisOp2MotionManager, Pages>{module, "RobotisOp2MotionManager", py::dynamic_attr()}.def(
      py::init<webots::Robot*, const std::string&>(), py::arg("robot"), py::arg("customMotionFile") = "",
      py::keep_alive<1, 2>(), kQuick);
}

template <class Directory, class Timer>
void bindOthers(py::module_& module, const std::string& robot) {
  py::class_<Directory>{module, (robot + "DirectoryManager").c_str()}.def_static("getDataDirectory",
                                                                                 &Directory::getDataDirectory);
  py::class_<Timer>{module, (robot + "MotionTimerManager").c_str()}.def_static("MotionTimerInit",
                                                                               &Timer::MotionTimerInit);
}

}  // namespace

void bindManagers(py::module_& module) {
  bindGait(module);
  bindMotionPages(module);
  bindVision(module);
  bindOthers<DARwInOPDirectoryManager, DARwInOPMotionTimerManager>(module, "DARwInOP");
  bindOthers<RobotisOp2DirectoryManager, RobotisOp2MotionTimerManager>(module, "RobotisOp2");
}

}  // namespace darwinop::python
