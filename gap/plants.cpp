#include "gap/plants.hpp"

#include "gap/plant/bench/bench_plant.hpp"

namespace darwinop::gap {

const Plant& plantOf(const Case& /*given*/) {
  static const BenchPlant kBench;
  return kBench;
}

}  // namespace darwinop::gap
