// Any image and thresholds: every SIMD kernel equals the plain one.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "managers/vision/colour_finder.hpp"
#include "tests/managers/vision/naive.hpp"

namespace {

using namespace darwinop::vision;

void require(bool holds) {
  if (!holds) std::abort();
}

/// The bytes of the input, one after the other; zeros behind them.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_{data}, end_{data + size} {}
  std::uint8_t next() { return at_ == end_ ? std::uint8_t{0} : *at_++; }
  /// `least` to `most`, evenly enough.
  int upTo(int least, int most) {
    const int high = next(), low = next();
    return least + (256 * high + low) % (most - least + 1);
  }
  [[nodiscard]] bool isEmpty() const { return at_ == end_; }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

/// Runs of one colour: a colour and how often, so that a few bytes make patches that survive.
std::vector<std::uint8_t> picture(Input& input, std::size_t pixels) {
  std::vector<std::uint8_t> bgra;
  bgra.reserve(4 * pixels);
  while (bgra.size() < 4 * pixels) {
    const std::uint8_t blue = input.next(), green = input.next(), red = input.next();
    std::size_t count = input.isEmpty() ? pixels : 1u + input.next();
    for (; count > 0 && bgra.size() < 4 * pixels; --count) bgra.insert(bgra.end(), {blue, green, red, 255});
  }
  return bgra;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input{data, size};
  const int width = input.upTo(1, 140), height = input.upTo(1, 12);
  const Thresholds wanted{input.upTo(0, 360), input.upTo(0, 180), input.upTo(-2, 101), input.upTo(-2, 101)};
  const PercentLimits limits{input.upTo(0, 1000) / 10.0, input.upTo(0, 1000) / 10.0};
  const std::vector<std::uint8_t> bgra =
      picture(input, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

  const naive::Result expected =
      naive::find(bgra.data(), width, height,
                  {wanted.hue, wanted.hue_tolerance, wanted.min_saturation, wanted.min_value}, limits.min, limits.max);
  for (const Instructions instructions : kAllInstructions) {
    if (!canUse(instructions)) continue;
    ColourFinder finder{width, height, wanted, limits, instructions};
    const auto found = finder.find(bgra);
    require(found.has_value() == expected.found);
    require(!found || *found == Pixel{expected.x, expected.y});
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) require(finder.isDetected(x, y) == expected.mask.at(x, y));
  }
  return 0;
}
