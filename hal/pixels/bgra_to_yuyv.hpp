// The way back, for virtual cameras: an upright picture in BGRA to what a camera mounted upside down would have given.
#pragma once

#include <cstdint>
#include <span>

#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::pixels {

// The inverse of yuyv_to_bgra.hpp over the full range, in 1/65536, rounded to nearest. U and V of a pair come from the
// mean of its two colours. A picture of one colour comes back within 2 counts in each channel: rounding Y, U and V
// costs up to 1.4, rounding down on the way to BGRA up to 1.

/// `bgra`: 4 * width * height bytes; `yuyv`: at least yuyvBytes(width, height, stride). Turned by 180 degrees, so that
/// yuyvToBgraRotated gives the picture as it was. Of an odd width's last pair Y1 repeats Y0. What lies between a row's
/// last pair and the next row stays as it is. Does not allocate.
void bgraToYuyvRotated(std::span<const std::uint8_t> bgra, int width, int height, std::span<std::uint8_t> yuyv,
                       std::size_t stride) noexcept;

}  // namespace darwinop::pixels
