// Python classes of the managers, under the names of today and of 2013.
#include <DARwInOPDirectoryManager.hpp>
#include <RobotisOp2DirectoryManager.hpp>
#include <RobotisOp2GaitManager.hpp>
#include <RobotisOp2MotionManager.hpp>
#include <RobotisOp2MotionTimerManager.hpp>
#include <RobotisOp2VisionManager.hpp>
#include <webots/Robot.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

namespace {

using namespace ::managers;

using Gait = DARwInOPGaitManager;

void bindParameters(OwnedClass<Gait>& gait) {
  using Parameters = Gait::GaitParameters;
  py::class_<Parameters> parameters{gait, "GaitParameters"};
  parameters.def(py::init<>());
  constexpr std::pair<const char*, double Parameters::*> kMembers[] = {
      {"x_offset", &Parameters::x_offset},
      {"y_offset", &Parameters::y_offset},
      {"z_offset", &Parameters::z_offset},
      {"roll_offset", &Parameters::roll_offset},
      {"pitch_offset", &Parameters::pitch_offset},
      {"yaw_offset", &Parameters::yaw_offset},
      {"hip_pitch_offset", &Parameters::hip_pitch_offset},
      {"period_time", &Parameters::period_time},
      {"dsp_ratio", &Parameters::dsp_ratio},
      {"step_forward_back_ratio", &Parameters::step_forward_back_ratio},
      {"foot_height", &Parameters::foot_height},
      {"swing_right_left", &Parameters::swing_right_left},
      {"swing_top_down", &Parameters::swing_top_down},
      {"pelvis_offset", &Parameters::pelvis_offset},
      {"arm_swing_gain", &Parameters::arm_swing_gain},
      {"balance_knee_gain", &Parameters::balance_knee_gain},
      {"balance_ankle_pitch_gain", &Parameters::balance_ankle_pitch_gain},
      {"balance_hip_roll_gain", &Parameters::balance_hip_roll_gain},
      {"balance_ankle_roll_gain", &Parameters::balance_ankle_roll_gain},
      {"p_gain", &Parameters::p_gain}};
  for (const auto& [name, member] : kMembers) parameters.def_readwrite(name, member);
  gait.def("setParameters", &Gait::setParameters, py::arg("parameters"), kQuick);
  reads(gait, "getParameters", &Gait::getParameters, "setParameters");
}

void bindGait(py::module_& module) {
  OwnedClass<Gait> gait{module, "DARwInOPGaitManager", py::dynamic_attr()};
  gait.def(py::init<webots::Robot*, const std::string&>(), py::arg("robot"), py::arg("iniFilename"),
           py::keep_alive<1, 2>(), kQuick);
  gait.def("isCorrectlyInitialized", &Gait::isCorrectlyInitialized, kQuick);
  gait.def("setXAmplitude", &Gait::setXAmplitude, py::arg("x"), kQuick);
  gait.def("setYAmplitude", &Gait::setYAmplitude, py::arg("y"), kQuick);
  gait.def("setAAmplitude", &Gait::setAAmplitude, py::arg("a"), kQuick);
  gait.def("setMoveAimOn", &Gait::setMoveAimOn, py::arg("on"), kQuick);
  gait.def("setBalanceEnable", &Gait::setBalanceEnable, py::arg("on"), kQuick);
  bindParameters(gait);
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
