// Where an experiment is, told while it runs: one line that is written over on a terminal, else one line a phase.
#include "experiments/run/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace darwinop::experiments {

Progress::Progress(double total_s) : total_s_{total_s}, terminal_{isatty(STDERR_FILENO) == 1} {}

Progress::~Progress() {
  if (terminal_ && !phase_.empty()) std::fputs("\n", stderr);
}

void Progress::tell(const std::string& phase, double seconds) {
  const bool is_new = phase != phase_;
  const int quarter = static_cast<int>(seconds * 4);
  phase_ = phase;
  if (terminal_ && (is_new || quarter != quarter_))
    std::fprintf(stderr, "\r%6.1f s of at most %.0f s  %s\033[K", seconds, total_s_, phase.c_str());
  else if (!terminal_ && is_new)
    std::fprintf(stderr, "%6.1f s  %s\n", seconds, phase.c_str());
  quarter_ = quarter;
}

}  // namespace darwinop::experiments
