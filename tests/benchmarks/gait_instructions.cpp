// For callgrind, on PC and robot: `gait_instructions ours|plain CALLS`. What a call costs is the difference between two
// runs of different length.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "gait_work.hpp"

namespace {

using namespace darwinop::bench;

template <class Gait>
int run(long calls) {
  Gait gait;
  for (long i = 0; i < calls; ++i) asm volatile("" : : "r"(&gait.call()) : "memory");  // somebody reads the goals
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc == 3 ? argv[1] : "";
  const long calls = argc == 3 ? std::atol(argv[2]) : 0;
  if (kind == "check") return gaitsAreTheSame() ? 0 : 1;
  if (kind == "ours") return run<OurGait>(calls);
  if (kind == "plain") return run<PeersGait>(calls);
  std::fprintf(stderr, "usage: %s ours|plain CALLS, or check 1\n", argv[0]);
  return 2;
}
