// Plane rows with NEON, 16 pixels at a time.
#include "hal/pixels/plane_rows.hpp"

#ifdef __ARM_NEON
#include <arm_neon.h>

namespace darwinop::pixels {
namespace {

inline uint8x16_t turned(uint8x16_t bytes) {
  const uint8x16_t halves = vrev64q_u8(bytes);
  return vextq_u8(halves, halves, 8);
}

inline uint8x8_t turnedMean(uint8x8_t a, uint8x8_t b) {
  return vrev64_u8(vrhadd_u8(a, b));
}

}  // namespace

void lumaRowNeon(const std::uint8_t* yuyv, int width, std::uint8_t* y) noexcept {
  int left = width;  // pixels
  for (; left >= 16; left -= 16, y += 16) vst1q_u8(y, turned(vld2q_u8(yuyv + 2 * (left - 16)).val[0]));
  lumaRowScalar(yuyv, left, y);
}

void chromaRowNeon(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* u,
                   std::uint8_t* v) noexcept {
  int left = width;
  for (; left % 2 == 0 && left >= 16; left -= 16, u += 8, v += 8) {  // odd widths mix pairs; no camera has them
    const int at = 2 * (left - 16);
    const uint8x8x4_t above = vld4_u8(upper + at), below = vld4_u8(lower + at);
    vst1_u8(u, turnedMean(above.val[1], below.val[1]));
    vst1_u8(v, turnedMean(above.val[3], below.val[3]));
  }
  chromaRowScalar(upper, lower, left, u, v);
}

}  // namespace darwinop::pixels
#endif
