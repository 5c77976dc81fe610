// Converts the rows in reverse order with the fastest kernel of the CPU.
#include "hal/pixels/yuyv_to_bgra.hpp"

#include <array>
#include <cassert>
#include <utility>

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
  static const auto kernels = [] {
    auto list = std::to_array<Kernel<ToBgra>>({
        {"scalar", byRows<bgraRowScalar>, true},
#ifdef __SSE2__
        {"sse2", byRows<bgraRowSse2>, true},
        {"ssse3", byRows<bgraRowSsse3>, __builtin_cpu_supports("ssse3") != 0},
        {"avx2", byRows<bgraRowAvx2>, __builtin_cpu_supports("avx2") != 0},
#elif defined(__ARM_NEON)
        {"neon", byRows<bgraRowNeon>, true},
#endif
    });
#ifdef __SSE2__
    // pshufb takes four micro-operations on the robot's Atom: LLVM's model gives 40 cycles per 8 pixels for SSSE3, 33
    // for SSE2.
    if (__builtin_cpu_is("bonnell")) std::swap(list[1], list[2]);
#endif
    return list;
  }();
  return kernels;
}

void yuyvToBgraRotated(const YuyvImage& image, std::span<std::uint8_t> bgra) noexcept {
  static ToBgra* const function = fastest(bgraKernels()).function;
  function(image, bgra);
}

}  // namespace darwinop::pixels
