// What a camera sees on a field, drawn at random, and how far a picture of it is off.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "hal/pixels/bgra_to_yuyv.hpp"
#include "hal/pixels/yuyv_to_bgra.hpp"
#include "remote/jpeg/image_size.hpp"

namespace darwinop::bench {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::size_t kPixels = std::size_t{320} * 240;

/// A field with lines, a wall and a ball in the colours of `seed`, under light from one side, with a camera's noise.
/// Several: how well a flat colour survives is luck.
inline Bytes scene(std::uint32_t seed) {
  std::mt19937 rng{seed};
  const auto drawn = [&rng](double from, double to) {
    return from + (to - from) * static_cast<double>(rng() >> 8) / 0x1000000;
  };
  const auto colour = [&drawn] { return std::array{drawn(20, 240), drawn(20, 240), drawn(20, 240)}; };
  const std::array field = colour(), wall = colour(), line = colour(), ball = colour();
  const double tilt = drawn(0.05, 0.25), from_dark = drawn(0.5, 0.9);
  const double ball_x = drawn(100, 220), ball_y = drawn(90, 150);
  Bytes bgra(4 * kPixels);
  std::uint8_t* pixel = bgra.data();
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x, pixel += 4) {
      const double light = from_dark + (1 - from_dark) * x / 320, from_ball = std::hypot(x - ball_x, y - ball_y);
      const auto& at = from_ball < 24                                   ? ball
                       : y < 80                                         ? wall
                       : std::fmod(y + tilt * x, 45) < 4 || x % 110 < 3 ? line
                                                                        : field;
      for (int i = 0; i < 3; ++i)
        pixel[i] = static_cast<std::uint8_t>(std::clamp(at[i] * light + drawn(-4, 4), 0.0, 255.0));
      pixel[3] = 255;
    }
  return bgra;
}

/// The frame, and the part of it that a client sees, as JFIF's formula has its colours.
struct Frame {
  Frame(remote::ImageSize part, std::uint32_t seed) : size{part} {
    pixels::bgraToYuyvRotated(scene(seed), 320, 240, yuyv, 640);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const int at = 320 * 240 - 1 - (320 * (remote::topOf(size) + y) + remote::leftOf(size) + x);  // upside down
        const std::uint8_t* pair = yuyv.data() + at / 2 * 4;
        const double luma = pair[at % 2 * 2], u = pair[1] - 128, v = pair[3] - 128;
        for (const double c : {luma + 1.772 * u, luma - 0.344136 * u - 0.714136 * v, luma + 1.402 * v})
          colours.push_back(std::clamp(c, 0.0, 255.0));
      }
  }
  [[nodiscard]] pixels::YuyvImage image() const { return {yuyv, 320, 240, 640}; }

  remote::ImageSize size;
  Bytes yuyv = Bytes(2 * kPixels);
  std::vector<double> colours;  // blue, green, red
};

/// Mean square of what a picture is off, over the three colours.
inline double meanSquare(const Frame& frame, const Bytes& bgra) {
  double squares = 0;
  for (std::size_t i = 0; i < frame.colours.size(); ++i)
    squares += std::pow(bgra[i / 3 * 4 + i % 3] - frame.colours[i], 2);
  return squares / static_cast<double>(frame.colours.size());
}

}  // namespace darwinop::bench
