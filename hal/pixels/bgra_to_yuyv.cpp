// BGRA to YUYV by inverting the conversion formula.
#include "hal/pixels/bgra_to_yuyv.hpp"

#include <algorithm>
#include <cassert>

#include "hal/pixels/yuyv_to_bgra.hpp"

namespace darwinop::pixels {
namespace {

// From R = Y + r v, B = Y + b u and G = Y + gu u + gv v: v = (R - Y) / r, u = (B - Y) / b, and these in G give Y.
constexpr double kScale = 65536;
constexpr double kBlueInG = -double{kGreenU} / kBlueU, kRedInG = -double{kGreenV} / kRedV;
constexpr double kLumaG = 1 / (1 + kBlueInG + kRedInG), kLumaB = kBlueInG * kLumaG, kLumaR = kRedInG * kLumaG;

constexpr int rounded(double x) {
  return static_cast<int>(x < 0 ? x * kScale - 0.5 : x * kScale + 0.5);
}

/// Channel weights in 1/65536. Green takes the remainder, so that grey maps exactly to grey.
struct Weights {
  int b, g, r;
};
constexpr Weights withRest(int b, int r, int sum) {
  return {b, sum - b - r, r};
}
constexpr Weights kLuma = withRest(rounded(kLumaB), rounded(kLumaR), 65536);
constexpr Weights kU = withRest(rounded((1 - kLumaB) * 256 / kBlueU), rounded(-kLumaR * 256 / kBlueU), 0);
constexpr Weights kV = withRest(rounded(-kLumaB * 256 / kRedV), rounded((1 - kLumaR) * 256 / kRedV), 0);

/// Channels of one pixel, or their sums over two.
struct Colour {
  int b, g, r;
};
Colour colourAt(const std::uint8_t* bgra) {
  return {bgra[0], bgra[1], bgra[2]};
}

/// Divides by 2^bits: 16, or 17 for a sum over two pixels.
std::uint8_t weighed(const Weights& w, const Colour& c, int bits, int middle) {
  const int sum = w.b * c.b + w.g * c.g + w.r * c.r;  // at most 2 * 255 * 65536
  return static_cast<std::uint8_t>(std::clamp(middle + ((sum + (1 << (bits - 1))) >> bits), 0, 255));
}

/// A pair in camera order: `first` is right of `second` in the upright picture.
void putPair(const Colour& first, const Colour& second, std::uint8_t* yuyv) {
  const Colour both{first.b + second.b, first.g + second.g, first.r + second.r};
  yuyv[0] = weighed(kLuma, first, 16, 0);
  yuyv[1] = weighed(kU, both, 17, 128);
  yuyv[2] = weighed(kLuma, second, 16, 0);
  yuyv[3] = weighed(kV, both, 17, 128);
}

}  // namespace

void bgraToYuyvRotated(std::span<const std::uint8_t> bgra, int width, int height, std::span<std::uint8_t> yuyv,
                       std::size_t stride) noexcept {
  assert(bgra.size() == std::size_t{4} * width * height);
  assert(isWhole({yuyv, width, height, stride}));
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = bgra.data() + std::size_t{4} * width * (height - 1 - y);
    std::uint8_t* to = yuyv.data() + stride * y;
    for (int x = width - 1; x >= 0; x -= 2, to += 4)
      putPair(colourAt(row + 4 * x), colourAt(row + 4 * std::max(x - 1, 0)), to);
  }
}

}  // namespace darwinop::pixels
