// Inverse conversion for virtual cameras: upright BGRA to the YUYV of a camera mounted upside down.
#pragma once

#include <cstdint>
#include <span>

#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::pixels {

// Inverse of yuyv_to_bgra.hpp over the full range, in 1/65536, rounded to nearest. U and V of a pair come from the mean
// of its two colours. A single-colour picture survives the round trip within 2 counts per channel: rounding Y, U and V
// contributes up to 1.4, rounding down to BGRA up to 1.

/// `bgra`: 4 * width * height bytes; `yuyv`: at least yuyvBytes(width, height, stride). Rotated by 180 degrees, so that
/// yuyvToBgraRotated restores the picture. In the last pair of an odd width, Y1 repeats Y0. Padding between rows is not
/// written. Does not allocate.
void bgraToYuyvRotated(std::span<const std::uint8_t> bgra, int width, int height, std::span<std::uint8_t> yuyv,
                       std::size_t stride) noexcept;

}  // namespace darwinop::pixels
