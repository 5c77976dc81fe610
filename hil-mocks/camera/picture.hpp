// Picture type of the virtual camera's sources.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace darwinop::hil {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

/// Controller format: blue, green, red, 255 per pixel, top row first, no padding.
struct PaintedPicture {
  PaintedPicture(int width_px, int height_px)
      : width{width_px},
        height{height_px},
        bgra(4 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), 255) {}

  [[nodiscard]] std::size_t at(int x, int y) const {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  void set(int x, int y, Colour c) {
    const std::size_t i = at(x, y);
    bgra[i] = c[2];
    bgra[i + 1] = c[1];
    bgra[i + 2] = c[0];
  }
  [[nodiscard]] Colour colour(int x, int y) const {
    const std::size_t i = at(x, y);
    return {bgra[i + 2], bgra[i + 1], bgra[i]};
  }

  int width, height;
  std::vector<std::uint8_t> bgra;
};

}  // namespace darwinop::hil
