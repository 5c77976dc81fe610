// Experiment file: an error message, or a plan within every limit.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/format/shape.hpp"

namespace {

using namespace darwinop::experiments;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireWithinLimits(const Experiment& experiment) {
  const Ranges ranges = darwinop::safety::hardRanges();
  const Plan plan = makePlan(experiment, ranges);
  require(plan.seconds() <= 1800 && !planText(experiment, plan).empty());
  constexpr double kSlack = 2e-4;  // rad
  for (const JointPlan& joint : plan.moved) {
    const auto& range = ranges[index(joint.joint)];
    require(joint.low >= range.low.value - kSlack && joint.high <= range.high.value + kSlack);
    require(std::isfinite(joint.fastest) && joint.fastest <= 12.22);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    requireWithinLimits(parseExperiment({reinterpret_cast<const char*>(data), size}, "my.ini"));
  } catch (const std::runtime_error& refused) {
    require(!std::string_view{refused.what()}.empty());
  }
  return 0;
}
