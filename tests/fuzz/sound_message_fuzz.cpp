// Between controller and sound program: what is read is written as the same, an event as the same bytes.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "hal/audio/protocol.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace darwinop::audio;
  const std::span message{data, size};
  if (const auto order = decodeOrder(message)) {
    const Message again = encode(*order);
    // Not the same bytes: a whole speed is a number with a fraction on the wire, and -0 is read as 0.
    if (decodeOrder(again) != order || again.size() > kLongestMessage || again.size() > size) std::abort();
  }
  if (const auto event = decodeEvent(message); event && !std::ranges::equal(encode(*event), message)) std::abort();
  return 0;
}
