// Walking engine: 8 ms of walking per call.
#include "managers/gait/engine.hpp"

#include <limits>
#include <optional>

namespace darwinop::gait {

namespace {
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
}  // namespace

Engine::Engine(const Parameters& parameters)
    : parameters_{parameters}, timing_{parameters}, stride_{command_, parameters} {
  next({}, {kUnknown, kUnknown});
}

void Engine::start() {
  running_ = true;
  stopping_ = false;
}

void Engine::stop() {
  stopping_ = true;
}

const Goals& Engine::next(const WalkCommand& command, const Tilt& tilt) {
  if (!stopping_) command_ = command;
  updatePhase();
  const Feet feet = feetAt(time_ms_, timing_, stride_, parameters_);
  if (running_) {
    time_ms_ += kTickMs;
    if (time_ms_ >= timing_.period) time_ms_ = 0;
  }
  if (std::optional<Goals> reached = goalsFor(feet, parameters_)) {
    addBalance(*reached, tilt, parameters_);
    clampToJoints(*reached);
    goals_ = *reached;
  }
  return goals_;
}

/// Four events per period: both feet down (twice), where the walk may end; a foot at its highest point (twice), where
/// the next stride starts.
void Engine::updatePhase() {
  if (time_ms_ == 0) {
    applyParameters();
    return finishIfStopping();
  }
  if (isAt(time_ms_, timing_.middleOfLeft()) || isAt(time_ms_, timing_.middleOfRight())) {
    stride_ = Stride{command_, parameters_};
  } else if (isAt(time_ms_, timing_.middle())) {
    applyParameters();
    time_ms_ = timing_.middle();
    finishIfStopping();
  }
}

/// The stride keeps its amplitudes until the middle of the next swing, as with a new command.
void Engine::applyParameters() {
  if (!requested_) return;
  parameters_ = *requested_;
  timing_ = Timing{parameters_};
  requested_.reset();
}

void Engine::finishIfStopping() {
  if (!stopping_) return;
  if (stride_.stands)
    running_ = false;
  else
    command_ = {};
}

}  // namespace darwinop::gait
