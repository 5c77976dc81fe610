// Converts the rows in reverse order into planes.
#include "hal/pixels/yuyv_to_planes.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "hal/pixels/plane_rows.hpp"

namespace darwinop::pixels {
namespace {

constexpr std::uint8_t meanOf(int a, int b) {
  return static_cast<std::uint8_t>((a + b + 1) >> 1);
}

template <LumaRow& luma_row, ChromaRow& chroma_row>
void planesByRows(const YuyvImage& image, Chroma chroma, const Planes& planes) noexcept {
  assert(isWhole(image));
  assert(planes.y.size() == static_cast<std::size_t>(image.width) * image.height);
  assert(planes.u.size() == chromaBytes(image.width, image.height, chroma));
  assert(planes.v.size() == planes.u.size());
  const auto turned = [&](int y) { return image.bytes.data() + image.stride * (image.height - 1 - y); };
  const int rows = chroma == Chroma::k420 ? 2 : 1;  // per chroma row
  std::size_t at = 0;
  for (int y = 0; y < image.height; y += rows, at += pairsOf(image.width)) {
    const int last = std::min(y + rows, image.height) - 1;
    for (int i = y; i <= last; ++i)
      luma_row(turned(i), image.width, planes.y.data() + static_cast<std::size_t>(image.width) * i);
    chroma_row(turned(y), turned(last), image.width, planes.u.data() + at, planes.v.data() + at);
  }
}

}  // namespace

void lumaRowScalar(const std::uint8_t* yuyv, int width, std::uint8_t* y) noexcept {
  for (int x = width - 1; x >= 0; --x) *y++ = yuyv[2 * x];
}

void chromaRowScalar(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* u,
                     std::uint8_t* v) noexcept {
  for (int right = width - 1; right >= 0; right -= 2) {  // rotated: the camera's right becomes left
    const int a = right / 2 * 4, b = std::max(right - 1, 0) / 2 * 4;
    *u++ = meanOf(meanOf(upper[a + 1], upper[b + 1]), meanOf(lower[a + 1], lower[b + 1]));
    *v++ = meanOf(meanOf(upper[a + 3], upper[b + 3]), meanOf(lower[a + 3], lower[b + 3]));
  }
}

std::span<const Kernel<ToPlanes>> planesKernels() noexcept {
  static constexpr auto kKernels = std::to_array<Kernel<ToPlanes>>({
      {"scalar", planesByRows<lumaRowScalar, chromaRowScalar>, true},
#ifdef __SSE2__
      {"sse2", planesByRows<lumaRowSse2, chromaRowSse2>, true},
#elif defined(__ARM_NEON)
      {"neon", planesByRows<lumaRowNeon, chromaRowNeon>, true},
#endif
  });
  return kKernels;
}

void yuyvToPlanesRotated(const YuyvImage& image, Chroma chroma, const Planes& planes) noexcept {
  fastest(planesKernels()).function(image, chroma, planes);
}

}  // namespace darwinop::pixels
