// .motion file: an error with file, line and field, or finite curves.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "webots/motion_text.hpp"

namespace {

using namespace darwinop::webots_api;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireSane(const MotionCurve& curve, int duration_ms) {
  require(!curve.motor.empty());
  int before = 0;
  for (const MotionKey& key : curve.keys) {
    require(key.ms >= before && key.ms <= duration_ms && std::isfinite(key.rad));
    before = key.ms;
  }
  for (int i = 0; i <= 20; ++i) {
    const auto rad = curve.at(duration_ms / 20.0 * i);
    require(!rad || std::isfinite(*rad));
  }
  require(curve.at(duration_ms).has_value() != curve.keys.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const MotionText motion = parseMotion({reinterpret_cast<const char*>(data), size}, "fuzz.motion");
    require(motion.duration_ms >= 0);
    for (const MotionCurve& curve : motion.curves) requireSane(curve, motion.duration_ms);
  } catch (const std::runtime_error& refused) {
    require(std::string_view{refused.what()}.starts_with("fuzz.motion:"));
  }
  return 0;
}
