// config.ini: an error message, or values within their ranges.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "webots/config_ini.hpp"

namespace {

using namespace darwinop;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireSane(const webots_api::ControllerConfig& config) {
  require(config.time_step_ms >= 1 && config.time_step_ms <= 10000);
  require(webots_api::cameraHasSize(config.camera_width, config.camera_height));
  config.safety.visit([](std::string_view, const auto& value, auto low, auto... rest) {
    if constexpr (sizeof...(rest) == 3) {  // a number with low, high, unit, why; else a choice
      const auto high = std::get<0>(std::tuple{rest...});
      require(value >= low && value <= high);
    }
  });
  for (std::size_t i = 0; i < kJoints; ++i) {
    const safety::JointRange hard = safety::hardRange(static_cast<Joint>(i)), range = config.safety.range[i];
    require(range.low.value >= hard.low.value && range.high.value <= hard.high.value);
    require(range.low.value <= range.high.value);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    requireSane(webots_api::parseConfig({reinterpret_cast<const char*>(data), size}, "config.ini").config);
  } catch (const std::runtime_error& refused) {
    require(!std::string_view{refused.what()}.empty());
  }
  return 0;
}
