// From a camera that is mounted upside down to what a controller gets: YUYV to BGRA, turned by 180 degrees, in one
// pass.
#pragma once

#include <cstdint>
#include <span>

#include "hal/pixels/kernel.hpp"
#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::pixels {

// Full range, no 16..235. With u = U - 128 and v = V - 128:
//
//   R = (256 Y + 359 v) >> 8      G = (256 Y - 88 u - 183 v) >> 8      B = (256 Y + 454 u) >> 8
//
// >> 8 rounds down, towards minus infinity; then each is limited to 0..255. A is 255. These are upstream's numbers: its
// controllers have their colours tuned to them. All kernels give the same bytes for every Y, U and V.
inline constexpr int kRedV = 359, kGreenU = -88, kGreenV = -183, kBlueU = 454;  // 1/256

/// `bgra`: exactly 4 * width * height bytes, four a pixel, top row first, no gaps; it must not overlap the image, which
/// must be whole (isWhole). Any alignment will do. Does not allocate.
using ToBgra = void(const YuyvImage& image, std::span<std::uint8_t> bgra) noexcept;

/// By the fastest kernel that this CPU has; chosen at the first call.
ToBgra yuyvToBgraRotated;

std::span<const Kernel<ToBgra>> bgraKernels() noexcept;

}  // namespace darwinop::pixels
