#include "runtime/robot_notes.hpp"

#include "safety/fault_book.hpp"

namespace darwinop::runtime {

RobotNotes::RobotNotes(const RuntimeFiles& files) : released_{files.released}, held_{files.held} {}

bool RobotNotes::released() const {
  return released_.isSet() || !held_.warning().empty();
}

std::string RobotNotes::warning() const {
  const std::string& first = released_.warning();
  const std::string& second = held_.warning();
  return first + (first.empty() || second.empty() ? "" : "; ") + second;
}

void RobotNotes::update(const Sensors& seen) {
  if (seen.cycle == 0) return;
  released_.set(safety::keptLimp(seen.safety.active));
  const State state = seen.safety.state;
  if (state != State::kLimp)
    limp_since_.reset();
  else if (!limp_since_)
    limp_since_ = seen.cycle;
  if (drives(state) || state == State::kFoundStiff)
    held_.set(true);
  else if (limp_since_ && seen.cycle - *limp_since_ >= kPollRound)  // a loss of power would have been detected too
    held_.set(false);
}

void RobotNotes::noteServoPowerOff(const RuntimeFiles& files) {
  RobotNotes notes{files};
  if (notes.held()) notes.released_.set(true);
}

void RobotNotes::forget(const RuntimeFiles& files) {
  (void)removeAny(files.released);
  (void)removeAny(files.held);
}

}  // namespace darwinop::runtime
