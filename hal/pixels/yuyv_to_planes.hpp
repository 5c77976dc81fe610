// YUYV to planes of Y, U and V, turned by 180 degrees: what a JPEG encoder takes, without the way through BGRA.
#pragma once

#include <cstdint>
#include <span>

#include "hal/pixels/kernel.hpp"
#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::pixels {

// Y is copied. A chroma sample of 4:2:2 covers two pixels side by side, one of 4:2:0 two such pairs, one above the
// other; at the end of an odd width or height it covers what there is. It is the mean of what it covers, rounded up at
// a half: first in a row, (a + b + 1) >> 1 of two pixels, then of two rows in the same way. In a row, pixels of an even
// width have the same chroma already. Of an odd width they never have: turned, the pairs are others than the camera's.
enum class Chroma : std::uint8_t { k422, k420 };

/// Top row first, no gaps. They must overlap neither each other nor the image.
struct Planes {
  std::span<std::uint8_t> y;     // width * height bytes
  std::span<std::uint8_t> u, v;  // chromaBytes() bytes each
};

constexpr std::size_t chromaBytes(int width, int height, Chroma chroma) {
  return pairsOf(width) * (chroma == Chroma::k420 ? pairsOf(height) : static_cast<std::size_t>(height));
}

/// The image must be whole (isWhole). Any alignment will do. Does not allocate.
using ToPlanes = void(const YuyvImage& image, Chroma chroma, const Planes& planes) noexcept;

/// By the fastest kernel that this CPU has.
ToPlanes yuyvToPlanesRotated;

std::span<const Kernel<ToPlanes>> planesKernels() noexcept;

}  // namespace darwinop::pixels
