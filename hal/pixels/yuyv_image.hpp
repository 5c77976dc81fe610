// A picture in USB camera format: YUYV, two pixels in four bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace darwinop::pixels {

/// Bytes Y0 U Y1 V for each pair of pixels. In the last pair of an odd width, only Y0 is a pixel; U and V are valid.
struct YuyvImage {
  std::span<const std::uint8_t> bytes;
  int width = 0, height = 0;
  std::size_t stride = 0;  // bytes per row, from the driver
};

/// Pixel pairs per row; also the chroma samples per row of a plane.
constexpr std::size_t pairsOf(int width) {
  return (static_cast<std::size_t>(width) + 1) / 2;
}

/// Bytes of a row without the driver's padding.
constexpr std::size_t yuyvRowBytes(int width) {
  return 4 * pairsOf(width);
}

/// Bytes from the first to the last of a picture; padding after the last row is not accessed.
constexpr std::size_t yuyvBytes(int width, int height, std::size_t stride) {
  return stride * (static_cast<std::size_t>(height) - 1) + yuyvRowBytes(width);
}

/// Precondition of every function here. A driver may deliver less: check before converting.
constexpr bool isWhole(const YuyvImage& image) {
  return image.width > 0 && image.height > 0 && image.stride >= yuyvRowBytes(image.width) &&
         image.bytes.size() >= yuyvBytes(image.width, image.height, image.stride);
}

/// `into`: yuyvRowBytes(width) * height bytes, which must not overlap the image.
inline void copyWithoutGaps(const YuyvImage& image, std::span<std::uint8_t> into) noexcept {
  const std::size_t row = yuyvRowBytes(image.width);
  for (int y = 0; y < image.height; ++y) std::memcpy(into.data() + row * y, image.bytes.data() + image.stride * y, row);
}

}  // namespace darwinop::pixels
