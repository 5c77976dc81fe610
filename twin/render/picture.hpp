// RGB picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace darwinop::twin {

/// Three bytes per pixel (red, green, blue), top row first, no padding.
struct RenderedPicture {
  RenderedPicture() = default;
  RenderedPicture(int columns, int rows)
      : width{columns}, height{rows}, rgb(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * 3) {}

  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] std::uint8_t* at(int column, int row) {
    return rgb.data() + 3 * (static_cast<std::ptrdiff_t>(row) * width + column);
  }
  [[nodiscard]] const std::uint8_t* at(int column, int row) const {
    return rgb.data() + 3 * (static_cast<std::ptrdiff_t>(row) * width + column);
  }
};

}  // namespace darwinop::twin
