// Pictures for tests: any size and stride, bytes by a seed, and one pixel at a time as the definition has it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "hal/pixels/yuyv_to_bgra.hpp"

namespace darwinop::pixels {

template <class Function>
std::vector<Kernel<Function>> usable(std::span<const Kernel<Function>> kernels) {
  std::vector<Kernel<Function>> here;
  for (const auto& kernel : kernels)
    if (kernel.usable) here.push_back(kernel);
  return here;
}

struct Yuv {
  int y, u, v;
};

struct Picture {
  int width, height;
  std::size_t stride;
  std::vector<std::uint8_t> bytes;

  [[nodiscard]] YuyvImage image() const { return {bytes, width, height, stride}; }

  /// The pixel in column x of row y, as the camera has it.
  [[nodiscard]] Yuv at(int x, int y) const {
    const std::uint8_t* pair = bytes.data() + stride * y + x / 2 * 4;
    return {pair[x % 2 * 2], pair[1], pair[3]};
  }
  /// The same after turning by 180 degrees.
  [[nodiscard]] Yuv turned(int x, int y) const { return at(width - 1 - x, height - 1 - y); }
};

/// Bytes at random, the ends of their range more often; no byte more than the picture needs.
inline Picture pictureOf(int width, int height, std::size_t gap, std::uint32_t seed) {
  const std::size_t stride = yuyvRowBytes(width) + gap;
  Picture picture{width, height, stride, std::vector<std::uint8_t>(yuyvBytes(width, height, stride))};
  std::mt19937 dice{seed};
  for (std::uint8_t& byte : picture.bytes) {
    const auto number = dice();
    byte = static_cast<std::uint8_t>(number % 8 == 0 ? number / 8 % 2 * 255 : number >> 24);
  }
  return picture;
}

struct Bgra {
  std::uint8_t b, g, r, a;
  bool operator==(const Bgra&) const = default;
};

/// The definition, in real numbers, all of which a double holds exactly.
inline Bgra colourOf(const Yuv& pixel) {
  const double u = pixel.u - 128, v = pixel.v - 128;
  const auto limited = [](double x) { return static_cast<std::uint8_t>(x < 0 ? 0 : x > 255 ? 255 : std::floor(x)); };
  return {limited(pixel.y + u * 454 / 256), limited(pixel.y - u * 88 / 256 - v * 183 / 256),
          limited(pixel.y + v * 359 / 256), 255};
}

inline std::vector<std::uint8_t> expectedBgra(const Picture& picture) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Bgra c = colourOf(picture.turned(x, y));
      bytes.insert(bytes.end(), {c.b, c.g, c.r, c.a});
    }
  return bytes;
}

}  // namespace darwinop::pixels
