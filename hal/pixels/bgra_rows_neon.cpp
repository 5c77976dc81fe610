// BGRA rows with NEON: 16 pixels at a time. As in bgra_rows_x86.cpp the chroma term is computed once per pair.
#include "hal/pixels/bgra_rows.hpp"

#ifdef __ARM_NEON
#include <arm_neon.h>

namespace darwinop::pixels {
namespace {

/// Chroma terms of eight pairs.
struct Added {
  int16x8_t blue, green, red;
};

/// 128 u or 128 v: vqdmulh doubles a product and keeps its upper half, so that it multiplies and shifts by 8 exactly.
inline int16x8_t centred(uint8x8_t chroma) {
  return vshlq_n_s16(vsubq_s16(vreinterpretq_s16_u16(vmovl_u8(chroma)), vdupq_n_s16(128)), 7);
}

/// Green sums two products that together exceed 16 bits.
inline int16x4_t greenOf(int16x4_t u, int16x4_t v) {
  return vshrn_n_s32(vmlal_n_s16(vmull_n_s16(u, kGreenU), v, kGreenV), 15);
}

inline Added addedBy(uint8x8_t u_bytes, uint8x8_t v_bytes) {
  const int16x8_t u = centred(u_bytes), v = centred(v_bytes);
  return {vqdmulhq_n_s16(u, kBlueU),
          vcombine_s16(greenOf(vget_low_s16(u), vget_low_s16(v)), greenOf(vget_high_s16(u), vget_high_s16(v))),
          vqdmulhq_n_s16(v, kRedV)};
}

/// One channel of 16 pixels; narrowing saturates to 0..255.
inline uint8x16_t channel(int16x8_t first_luma, int16x8_t second_luma, int16x8_t added) {
  const uint8x8x2_t pixels =
      vzip_u8(vqmovun_s16(vaddq_s16(first_luma, added)), vqmovun_s16(vaddq_s16(second_luma, added)));
  return vcombine_u8(pixels.val[0], pixels.val[1]);
}

inline int16x8_t words(uint8x8_t bytes) {
  return vreinterpretq_s16_u16(vmovl_u8(bytes));
}

}  // namespace

void bgraRowNeon(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept {
  bgra = putOddBgra(yuyv, width, bgra);
  int left = width / 2 * 2;  // pixels
  for (; left >= 16; left -= 16, bgra += 64) {
    const uint8x8x4_t pairs = vld4_u8(yuyv + 2 * (left - 16));  // Y0, U, Y1, V of eight pairs
    const Added added = addedBy(vrev64_u8(pairs.val[1]), vrev64_u8(pairs.val[3]));
    const int16x8_t first = words(vrev64_u8(pairs.val[2])), second = words(vrev64_u8(pairs.val[0]));
    const uint8x16x4_t out = {{channel(first, second, added.blue), channel(first, second, added.green),
                               channel(first, second, added.red), vdupq_n_u8(255)}};
    vst4q_u8(bgra, out);
  }
  bgraRowScalar(yuyv, left, bgra);
}

}  // namespace darwinop::pixels
#endif
