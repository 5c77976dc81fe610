// Implements the upstream gait manager API with the walking engine.
#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>

#include "DARwInOPGaitManager.hpp"
#include "managers/gait/walking_config.hpp"
#include "managers/gait_parameters.hpp"
#include "managers/messages.hpp"
#include "managers/walker.hpp"

namespace managers {

namespace {

constexpr int kTick = static_cast<int>(darwinop::gait::kTickMs);
constexpr int kMaxStep = 10'000;  // ms, as for Robot::step() in config.ini

void setAmplitude(double& amplitude, double value, const char* call) {
  if (std::isnan(value)) return warnOfGait(std::string{call} + "(NaN) is ignored");
  amplitude = std::clamp(value, -1.0, 1.0);
}

}  // namespace

struct DARwInOPGaitManager::Walker final : GaitWalker {};

DARwInOPGaitManager::DARwInOPGaitManager(webots::Robot* robot, const std::string& ini_filename) : walker_{new Walker} {
  try {
    if (robot == nullptr) throw std::runtime_error(messages::kRobotIsNull);
    walker_->prepare(*robot, ini_filename);
  } catch (const std::exception& why) {
    warnOfGait(std::string{why.what()} + "; the gait manager is disabled");
  }
}

DARwInOPGaitManager::DARwInOPGaitManager(const DARwInOPGaitManager& other) : walker_{new Walker{*other.walker_}} {}

DARwInOPGaitManager& DARwInOPGaitManager::operator=(const DARwInOPGaitManager& other) {
  if (this == &other) return *this;
  Walker* const copy = new Walker{*other.walker_};
  delete walker_;
  walker_ = copy;
  return *this;
}

DARwInOPGaitManager::~DARwInOPGaitManager() {
  delete walker_;
}

bool DARwInOPGaitManager::isCorrectlyInitialized() {
  return walker_->robot != nullptr;
}

void DARwInOPGaitManager::setXAmplitude(double x) {
  setAmplitude(walker_->command.x, x, "setXAmplitude");
}

void DARwInOPGaitManager::setYAmplitude(double y) {
  setAmplitude(walker_->command.y, y, "setYAmplitude");
}

void DARwInOPGaitManager::setAAmplitude(double a) {
  setAmplitude(walker_->command.a, a, "setAAmplitude");
}

void DARwInOPGaitManager::setMoveAimOn(bool on) {
  walker_->command.aim = on;
}

void DARwInOPGaitManager::setBalanceEnable(bool on) {
  walker_->balance = on;
}

DARwInOPGaitManager::GaitParameters DARwInOPGaitManager::getParameters() const {
  return publicParameters(walker_->player.parameters());
}

bool DARwInOPGaitManager::setParameters(const GaitParameters& parameters) {
  darwinop::gait::Parameters changed = walker_->player.parameters();
  assign(changed, parameters);
  const std::string error =
      walker_->robot != nullptr ? darwinop::gait::findParameterError(changed) : messages::kNotInitialized;
  if (error.empty())
    walker_->player.setParameters(changed);
  else
    warnOfGait(messages::kParametersRefused + error);
  return error.empty();
}

void DARwInOPGaitManager::start() {
  if (walker_->canWalk()) walker_->requested = true;
}

void DARwInOPGaitManager::step(int ms) {
  walker_->stepped = true;
  if (!walker_->canWalk()) return;
  if (ms < kTick)
    return warnOfGait("step(" + std::to_string(ms) + ") has no effect; pass 8 ms or more, preferably a multiple of 8");
  walker_->step(std::min(ms, kMaxStep));
}

void DARwInOPGaitManager::stop() {
  walker_->stop();
}

}  // namespace managers
