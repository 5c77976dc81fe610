// For callgrind: `cycle_instructions loop|codec|plain|plain-goals SERVOS` runs 320 cycles and has only those counted.
#include <valgrind/callgrind.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "work.hpp"

namespace {

using namespace darwinop::bench;

template <class Work>
int measure(Work&& work) {
  for (std::uint64_t i = 0; i < kMeasured; ++i) {
    work.prepare();
    CALLGRIND_TOGGLE_COLLECT;
    work.run();
    CALLGRIND_TOGGLE_COLLECT;
  }
  if (work.plausible()) return 0;
  std::cerr << "the work measured was not what it should be: not every servo was driven and read\n";
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc == 3 ? argv[1] : "";
  const int servos = argc == 3 ? std::atoi(argv[2]) : 0;
  if (kind == "loop") return measure(LoopWork{servos, kMeasured});
  if (kind == "codec") return measure(CodecWork{servos});
  if (kind == "plain") return measure(PlainWork{servos, false});
  if (kind == "plain-goals") return measure(PlainWork{servos, true});
  std::cerr << "usage: " << argv[0] << " loop|codec|plain|plain-goals SERVOS\n";
  return 2;
}
