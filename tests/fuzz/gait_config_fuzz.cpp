// [Walking Config]: an error message, or a gait that can walk.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "managers/gait/engine.hpp"
#include "managers/gait/walking_config.hpp"

namespace {

using namespace darwinop;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireSane(const gait::Parameters& parameters) {
  for (const gait::ParameterRow& row : gait::kParameters) {
    const double value = parameters.*row.field;
    require(value >= row.low && value <= row.high);
  }
  gait::Engine engine{parameters};
  engine.start();
  for (int call = 0; call < 50; ++call) {
    const gait::Goals& goals = engine.next({1, -1, 1, false}, {100, -100});
    for (std::size_t i = 0; i < gait::kWalkingJoints; ++i)
      require(goals.tick[i] >= kJointTable[i].low && goals.tick[i] <= kJointTable[i].high);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    requireSane(gait::parseWalkingConfig({reinterpret_cast<const char*>(data), size}, "config.ini").parameters);
  } catch (const std::runtime_error& refused) {
    require(!std::string_view{refused.what()}.empty());
  }
  return 0;
}
