// YUYV of a camera mounted upside down to BGRA for controllers: conversion and 180 degree rotation in one pass.
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
// >> 8 rounds towards minus infinity; results are clamped to 0..255. A is 255. The constants are upstream's: existing
// controllers have their colours tuned to them. All kernels give the same bytes for every Y, U and V.
inline constexpr int kRedV = 359, kGreenU = -88, kGreenV = -183, kBlueU = 454;  // 1/256

/// `bgra`: exactly 4 * width * height bytes, top row first, no padding; must not overlap the image, which must be whole
/// (isWhole). No alignment requirement. Does not allocate.
using ToBgra = void(const YuyvImage& image, std::span<std::uint8_t> bgra) noexcept;

/// Uses the fastest kernel of this CPU, selected at the first call.
ToBgra yuyvToBgraRotated;

std::span<const Kernel<ToBgra>> bgraKernels() noexcept;

}  // namespace darwinop::pixels
