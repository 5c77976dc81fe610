// YUYV to planes of Y, U and V, rotated by 180 degrees: direct input of a JPEG encoder.
#pragma once

#include <cstdint>
#include <span>

#include "hal/pixels/kernel.hpp"
#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::pixels {

// Y is copied. A chroma sample of 4:2:2 covers two adjacent pixels, one of 4:2:0 two such pairs, one above the other;
// at the edge of an odd width or height it covers what exists. It is the mean, rounded half up: first within a row, (a
// + b + 1) >> 1, then of two rows in the same way. With an even width both pixels of a pair share their chroma; with an
// odd width the rotated pairs differ from the camera's.
enum class Chroma : std::uint8_t { k422, k420 };

/// Top row first, no padding. Must not overlap each other or the image.
struct Planes {
  std::span<std::uint8_t> y;     // width * height bytes
  std::span<std::uint8_t> u, v;  // chromaBytes() bytes each
};

constexpr std::size_t chromaBytes(int width, int height, Chroma chroma) {
  return pairsOf(width) * (chroma == Chroma::k420 ? pairsOf(height) : static_cast<std::size_t>(height));
}

/// The image must be whole (isWhole). No alignment requirement. Does not allocate.
using ToPlanes = void(const YuyvImage& image, Chroma chroma, const Planes& planes) noexcept;

/// Uses the fastest kernel of this CPU.
ToPlanes yuyvToPlanesRotated;

std::span<const Kernel<ToPlanes>> planesKernels() noexcept;

}  // namespace darwinop::pixels
