// webots::Supervisor: a Robot whose calls on the simulation report once that they have no effect.
#include "webots/Supervisor.hpp"

#include <string>

#include "webots/messages.hpp"
#include "webots/notices.hpp"

namespace webots {

namespace {
/// Warns once and returns the empty value of the call's type: false, NULL.
template <class T = void>
T notHere(const char* call) {
  darwinop::webots_api::warnOnce("Supervisor::" + std::string{call} + darwinop::webots_api::messages::kNoSceneTree);
  return T();
}
}  // namespace

Supervisor::Supervisor() = default;
Supervisor::Supervisor(darwinop::webots_api::RobotImpl* impl) : Robot(impl) {}
Supervisor::~Supervisor() = default;

Supervisor* Supervisor::getSupervisorInstance() {
  return dynamic_cast<Supervisor*>(getInstance());
}

Supervisor::SimulationMode Supervisor::simulationGetMode() const {
  notHere("simulationGetMode()");
  return SIMULATION_MODE_REAL_TIME;
}
bool Supervisor::movieIsReady() const {
  notHere("movieIsReady()");
  return true;
}
bool Supervisor::movieFailed() const {
  notHere("movieFailed()");
  return true;
}
int Supervisor::movieGetStatus() const {
  notHere("movieGetStatus()");
  return MOVIE_READY;
}
int Supervisor::getMovieStatus() const {
  return movieGetStatus();
}

// One row per call: result, name, types of the arguments, const.
#define DARWINOP_NOT_HERE(RESULT, NAME, ARGUMENTS, CONST) \
  RESULT Supervisor::NAME ARGUMENTS CONST {               \
    return notHere<RESULT>(#NAME "()");                   \
  }
DARWINOP_NOT_HERE(void, simulationQuit, (int), )
DARWINOP_NOT_HERE(void, simulationSetMode, (SimulationMode), )
DARWINOP_NOT_HERE(void, simulationReset, (), )
DARWINOP_NOT_HERE(void, simulationResetPhysics, (), )
DARWINOP_NOT_HERE(void, simulationPhysicsReset, (), )
DARWINOP_NOT_HERE(void, simulationRevert, (), )
DARWINOP_NOT_HERE(void, worldLoad, (const std::string&), )
DARWINOP_NOT_HERE(bool, worldSave, (), )
DARWINOP_NOT_HERE(bool, worldSave, (const std::string&), )
DARWINOP_NOT_HERE(void, worldReload, (), )
DARWINOP_NOT_HERE(void, loadWorld, (const std::string&), )
DARWINOP_NOT_HERE(bool, saveWorld, (), )
DARWINOP_NOT_HERE(bool, saveWorld, (const std::string&), )
DARWINOP_NOT_HERE(void, exportImage, (const std::string&, int), const)
DARWINOP_NOT_HERE(void, movieStartRecording, (const std::string&, int, int, int, int, int, bool), )
DARWINOP_NOT_HERE(void, movieStopRecording, (), )
DARWINOP_NOT_HERE(void, startMovie, (const std::string&, int, int, int, int, int, bool), )
DARWINOP_NOT_HERE(void, stopMovie, (), )
DARWINOP_NOT_HERE(bool, animationStartRecording, (const std::string&), )
DARWINOP_NOT_HERE(bool, animationStopRecording, (), )
DARWINOP_NOT_HERE(void, setLabel, (int, const std::string&, double, double, double, int, double, const std::string&), )
DARWINOP_NOT_HERE(Node*, getRoot, (), const)
DARWINOP_NOT_HERE(Node*, getSelf, (), const)
DARWINOP_NOT_HERE(Node*, getFromDef, (const std::string&), const)
DARWINOP_NOT_HERE(Node*, getFromId, (int), const)
DARWINOP_NOT_HERE(Node*, getFromDevice, (const Device*), const)
DARWINOP_NOT_HERE(Node*, getFromDeviceTag, (int), const)
DARWINOP_NOT_HERE(Node*, getSelected, (), const)
DARWINOP_NOT_HERE(bool, virtualRealityHeadsetIsUsed, (), const)
DARWINOP_NOT_HERE(const double*, virtualRealityHeadsetGetPosition, (), const)
DARWINOP_NOT_HERE(const double*, virtualRealityHeadsetGetOrientation, (), const)
#undef DARWINOP_NOT_HERE

}  // namespace webots
