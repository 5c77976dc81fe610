// CPU time of one call of the gait's engine, beside the published algorithm written down as it reads.
#include <benchmark/benchmark.h>

#include <cstdio>

#include "gait_work.hpp"

namespace {

using namespace darwinop::bench;

template <class Gait>
void call(benchmark::State& state) {
  Gait gait;
  for (auto _ : state) benchmark::DoNotOptimize(gait.call());
}

BENCHMARK(call<OurGait>)->Name("ours");
BENCHMARK(call<PeersGait>)->Name("plain");

}  // namespace

int main(int argc, char** argv) {
  if (!gaitsAreTheSame()) return std::fputs("the two gaits are not the same\n", stderr), 1;
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
