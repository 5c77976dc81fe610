// The walking engine: one call, 8 ms of walking. Plain numbers in, joint goals out; no clock, no robot, no heap.
#include "managers/gait/engine.hpp"

#include <limits>
#include <optional>

namespace darwinop::gait {

namespace {
constexpr double kUnseen = std::numeric_limits<double>::quiet_NaN();
}  // namespace

Engine::Engine(const Parameters& parameters)
    : parameters_{parameters}, timing_{parameters}, stride_{wish_, parameters} {
  next({}, {kUnseen, kUnseen});
}

void Engine::start() {
  running_ = true;
  stopping_ = false;
}

void Engine::stop() {
  stopping_ = true;
}

const Goals& Engine::next(const Wish& wish, const Tilt& tilt) {
  if (!stopping_) wish_ = wish;
  turnThePage();
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

/// Four moments of the period: both feet down, twice, where it may end; a foot at its highest, twice, where the next
/// stride begins.
void Engine::turnThePage() {
  if (time_ms_ == 0) return comeToRest();
  if (isAt(time_ms_, timing_.middleOfLeft()) || isAt(time_ms_, timing_.middleOfRight())) {
    stride_ = Stride{wish_, parameters_};
  } else if (isAt(time_ms_, timing_.middle())) {
    time_ms_ = timing_.middle();
    comeToRest();
  }
}

void Engine::comeToRest() {
  if (!stopping_) return;
  if (stride_.stands)
    running_ = false;
  else
    wish_ = {};
}

}  // namespace darwinop::gait
