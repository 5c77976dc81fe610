// One row of YUYV to BGRA in reverse pixel order; used by yuyv_to_bgra.cpp only.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hal/pixels/yuyv_to_bgra.hpp"

namespace darwinop::pixels {

/// Reads the pairs of `width` pixels, writes 4 * width bytes.
using BgraRow = void(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept;

BgraRow bgraRowScalar;
#ifdef __SSE2__
BgraRow bgraRowSse2, bgraRowSsse3, bgraRowAvx2;
#elif defined(__ARM_NEON)
BgraRow bgraRowNeon;
#endif

inline void putBgra(int luma, int u, int v, std::uint8_t* bgra) noexcept {
  const auto limited = [](int value) { return static_cast<std::uint8_t>(std::clamp(value >> 8, 0, 255)); };
  bgra[0] = limited(256 * luma + kBlueU * u);
  bgra[1] = limited(256 * luma + kGreenU * u + kGreenV * v);
  bgra[2] = limited(256 * luma + kRedV * v);
  bgra[3] = 255;
}

/// Y0 U Y1 V to eight bytes, Y1 first.
inline void putBgraPair(const std::uint8_t* pair, std::uint8_t* bgra) noexcept {
  const int u = pair[1] - 128, v = pair[3] - 128;
  putBgra(pair[2], u, v, bgra);
  putBgra(pair[0], u, v, bgra + 4);
}

/// The half pair at the end of an odd width. Returns the next output position.
inline std::uint8_t* putOddBgra(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept {
  if (width % 2 == 0) return bgra;
  const std::uint8_t* pair = yuyv + 2 * (width - 1);
  putBgra(pair[0], pair[1] - 128, pair[3] - 128, bgra);
  return bgra + 4;
}

}  // namespace darwinop::pixels
