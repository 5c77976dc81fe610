#include "runtime/robot_notes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "safety/fault_book.hpp"

namespace darwinop::runtime {
namespace {

// After this many limp cycles each servo was polled once (safety/guard_states.cpp), and a loss of power was detected.
constexpr std::uint64_t kAllPolled = kJoints + 5;

bool exists(const std::string& path) {
  return access(path.c_str(), F_OK) == 0;
}

}  // namespace

RobotNotes::RobotNotes(const RuntimeFiles& files)
    : released_{files.released, exists(files.released)}, held_{files.held, exists(files.held)} {}

void RobotNotes::Note::set(bool wanted) {
  if (wanted == exists) return;
  exists = wanted;
  if (!wanted) {
    unlink(path.c_str());
    return;
  }
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (file >= 0) close(file);
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
  else if (limp_since_ && seen.cycle - *limp_since_ >= kAllPolled)
    held_.set(false);
}

void RobotNotes::forget(const RuntimeFiles& files) {
  unlink(files.released.c_str());
  unlink(files.held.c_str());
}

}  // namespace darwinop::runtime
