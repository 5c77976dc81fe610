// The rows of a picture from last to first, by the kernel that suits the CPU.
#include "hal/pixels/yuyv_to_bgra.hpp"

#include <array>
#include <cassert>

#include "hal/pixels/bgra_rows.hpp"

namespace darwinop::pixels {
namespace {

template <BgraRow& row>
void byRows(const YuyvImage& image, std::span<std::uint8_t> bgra) noexcept {
  assert(isWhole(image));
  assert(bgra.size() == std::size_t{4} * image.width * image.height);
  for (int y = 0; y < image.height; ++y)
    row(image.bytes.data() + image.stride * (image.height - 1 - y), image.width,
        bgra.data() + std::size_t{4} * image.width * y);
}

}  // namespace

void bgraRowScalar(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept {
  bgra = putOddBgra(yuyv, width, bgra);
  for (const std::uint8_t* pair = yuyv + 4 * (width / 2); pair != yuyv; bgra += 8) putBgraPair(pair -= 4, bgra);
}

std::span<const Kernel<ToBgra>> bgraKernels() noexcept {
#ifdef __SSE2__
  static const std::array<Kernel<ToBgra>, 4> kernels{{
      {"scalar", byRows<bgraRowScalar>, true},
      {"sse2", byRows<bgraRowSse2>, true},
      {"ssse3", byRows<bgraRowSsse3>, __builtin_cpu_supports("ssse3") != 0},
      {"avx2", byRows<bgraRowAvx2>, __builtin_cpu_supports("avx2") != 0},
  }};
#else
  static const std::array<Kernel<ToBgra>, 1> kernels{{{"scalar", byRows<bgraRowScalar>, true}}};
#endif
  return kernels;
}

void yuyvToBgraRotated(const YuyvImage& image, std::span<std::uint8_t> bgra) noexcept {
  static ToBgra* const function = fastest(bgraKernels()).function;
  function(image, bgra);
}

}  // namespace darwinop::pixels
