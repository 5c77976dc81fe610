// CPU time of a cycle's work, by Google Benchmark: the loop, the packet code alone, and the plain peer.
#include <benchmark/benchmark.h>

#include "work.hpp"

namespace {

using namespace darwinop::bench;

constexpr std::uint64_t kCycles = 20000;

template <class Work>
void measure(benchmark::State& state, Work&& work) {
  for (auto _ : state) {
    work.prepare();
    work.run();
  }
  if (!work.plausible()) state.SkipWithError("not every servo was driven and read");
}

void loop(benchmark::State& state) {
  measure(state, LoopWork{static_cast<int>(state.range(0)), kCycles});
}
void codec(benchmark::State& state) {
  measure(state, CodecWork{static_cast<int>(state.range(0))});
}
void plain(benchmark::State& state) {
  measure(state, PlainWork{static_cast<int>(state.range(0)), false});
}
void plainGoals(benchmark::State& state) {
  measure(state, PlainWork{static_cast<int>(state.range(0)), true});
}

// The loop's run is recorded beforehand, so its length is fixed.
BENCHMARK(loop)->Arg(5)->Arg(10)->Arg(20)->Iterations(kCycles);
BENCHMARK(plain)->Arg(5)->Arg(10)->Arg(20);
BENCHMARK(codec)->Arg(5)->Arg(10)->Arg(20)->Arg(30);
BENCHMARK(plainGoals)->Arg(5)->Arg(10)->Arg(20)->Arg(30);

}  // namespace

BENCHMARK_MAIN();
