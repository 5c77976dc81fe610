// What a page says on the steering channel: whatever the bytes, a goal that comes out of them is a number.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "window/steering_words.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string why;
  const auto words = darwinop::window::readSteering({reinterpret_cast<const char*>(data), size}, why);
  if (!words && why.empty()) __builtin_trap();
  if (words)
    for (const auto& [joint, goal] : words->goals)
      if (darwinop::index(joint) >= darwinop::kJoints || !std::isfinite(goal.value)) __builtin_trap();
  return 0;
}
