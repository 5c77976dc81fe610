// NEON colour filter, 16 pixels at a time (ARM boards such as a Raspberry Pi 2 or later).
#include "managers/vision/classify.hpp"

#ifdef __ARM_NEON
#include <arm_neon.h>

#include "managers/vision/classify_kernel.hpp"
#endif

namespace darwinop::vision {

#ifdef __ARM_NEON
namespace {

inline int16x8_t words(uint8x16_t a) {
  return vreinterpretq_s16_u8(a);
}
inline uint8x16_t bytes(int16x8_t a) {
  return vreinterpretq_u8_s16(a);
}

struct Sixteen {
  using Reg = uint8x16_t;
  using Bits = std::uint16_t;
  static constexpr int kBytes = 16;

  static Reg load(const std::uint8_t* from) { return vld1q_u8(from); }
  static Reg table(const std::int8_t* of_16) { return vreinterpretq_u8_s8(vld1q_s8(of_16)); }
  static Reg all(int byte) { return vdupq_n_u8(static_cast<std::uint8_t>(byte)); }
  static Reg all16(int low, int high) {
    return bytes(vdupq_n_s16(static_cast<std::int16_t>((low & 0xFF) | high * 256)));
  }
  static Reg zero() { return vdupq_n_u8(0); }
  static Reg ones() { return vdupq_n_u8(0xFF); }

  static Reg both(Reg a, Reg b) { return vandq_u8(a, b); }
  static Reg either(Reg a, Reg b) { return vorrq_u8(a, b); }
  static Reg unlike(Reg a, Reg b) { return veorq_u8(a, b); }
  static Reg butNot(Reg a, Reg b) { return vbicq_u8(a, b); }

  static Reg min(Reg a, Reg b) { return vminq_u8(a, b); }
  static Reg max(Reg a, Reg b) { return vmaxq_u8(a, b); }
  static Reg minus(Reg a, Reg b) { return vsubq_u8(a, b); }
  static Reg equal(Reg a, Reg b) { return vceqq_u8(a, b); }
  static Reg notLess(Reg a, Reg b) { return vcgeq_u8(a, b); }
  static Reg more(Reg a, Reg b) { return vcgtq_s8(vreinterpretq_s8_u8(a), vreinterpretq_s8_u8(b)); }  // signed
  static Reg lookUp(Reg table, Reg index) {
#ifdef __aarch64__
    return vqtbl1q_u8(table, index);
#else
    const uint8x8x2_t halves = {{vget_low_u8(table), vget_high_u8(table)}};
    return vcombine_u8(vtbl2_u8(halves, vget_low_u8(index)), vtbl2_u8(halves, vget_high_u8(index)));
#endif
  }

  static Reg even(Reg a) {
    return both(a, bytes(vdupq_n_s16(0xFF)));
  }
  static Reg odd(Reg a) {
    return vreinterpretq_u8_u16(vshrq_n_u16(vreinterpretq_u16_u8(a), 8));
  }
  static Reg narrow(Reg a, Reg b) {
    return vcombine_u8(vqmovun_s16(words(a)), vqmovun_s16(words(b)));
  }
  static Reg narrowSigns(Reg a, Reg b) {
    return vreinterpretq_u8_s8(vcombine_s8(vqmovn_s16(words(a)), vqmovn_s16(words(b))));
  }
  static Reg lower(Reg a, Reg b) {
    return vzipq_u8(a, b).val[0];
  }
  static Reg upper(Reg a, Reg b) {
    return vzipq_u8(a, b).val[1];
  }
  /// Bytes without a sign times factors with one: the saturated sum of two neighbours, as pmaddubsw.
  static Reg products(Reg of, Reg factors) {
    const int16x8_t signed_even = vshrq_n_s16(vshlq_n_s16(words(factors), 8), 8);
    const int16x8_t signed_odd = vshrq_n_s16(words(factors), 8);
    return bytes(vqaddq_s16(vmulq_s16(words(even(of)), signed_even), vmulq_s16(words(odd(of)), signed_odd)));
  }
  static Reg plus16(Reg a, Reg b) {
    return bytes(vqaddq_s16(words(a), words(b)));
  }

  static bool any(Reg a) {
    return toBits(a) != 0;
  }
  /// The highest bit of each byte.
  static Bits toBits(Reg a) {
    static constexpr std::uint8_t kWeights[16] = {1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128};
    const Reg signs = vreinterpretq_u8_s8(vshrq_n_s8(vreinterpretq_s8_u8(a), 7));
    const Reg weighted = both(signs, vld1q_u8(kWeights));
    uint8x8_t sums = vpadd_u8(vget_low_u8(weighted), vget_high_u8(weighted));
    sums = vpadd_u8(sums, sums);
    sums = vpadd_u8(sums, sums);
    return vget_lane_u16(vreinterpret_u16_u8(sums), 0);
  }
};

}  // namespace

const bool kHasClassifyNeon = true;
void classifyNeon(const ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits) {
  classifyWith<Sixteen>(test, bgra, width, bits);
}
#else
const bool kHasClassifyNeon = false;
void classifyNeon(const ColourTest&, const std::uint8_t*, int, std::uint64_t*) {}
#endif

}  // namespace darwinop::vision
