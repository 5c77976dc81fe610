// SSSE3 colour filter, 16 pixels at a time (Intel and AMD processors since 2011 and the robot's Atom).
#include "managers/vision/classify.hpp"

#ifdef __SSSE3__
#include <tmmintrin.h>

#include "managers/vision/classify_kernel.hpp"
#endif

namespace darwinop::vision {

#ifdef __SSSE3__
namespace {

struct Sixteen {
  using Reg = __m128i;
  using Bits = std::uint16_t;
  static constexpr int kBytes = 16;

  static Reg load(const std::uint8_t* from) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from)); }
  static Reg table(const std::int8_t* of_16) { return _mm_load_si128(reinterpret_cast<const __m128i*>(of_16)); }
  static Reg all(int byte) { return _mm_set1_epi8(static_cast<char>(byte)); }
  static Reg all16(int low, int high) { return _mm_set1_epi16(static_cast<short>((low & 0xFF) | high * 256)); }
  static Reg zero() { return _mm_setzero_si128(); }
  static Reg ones() { return _mm_set1_epi8(-1); }

  static Reg both(Reg a, Reg b) { return _mm_and_si128(a, b); }
  static Reg either(Reg a, Reg b) { return _mm_or_si128(a, b); }
  static Reg unlike(Reg a, Reg b) { return _mm_xor_si128(a, b); }
  static Reg butNot(Reg a, Reg b) { return _mm_andnot_si128(b, a); }

  static Reg min(Reg a, Reg b) { return _mm_min_epu8(a, b); }
  static Reg max(Reg a, Reg b) { return _mm_max_epu8(a, b); }
  static Reg minus(Reg a, Reg b) { return _mm_sub_epi8(a, b); }
  static Reg equal(Reg a, Reg b) { return _mm_cmpeq_epi8(a, b); }
  static Reg notLess(Reg a, Reg b) { return equal(max(a, b), a); }
  static Reg more(Reg a, Reg b) { return _mm_cmpgt_epi8(a, b); }  // signed
  static Reg lookUp(Reg table, Reg index) { return _mm_shuffle_epi8(table, index); }

  static Reg even(Reg a) { return both(a, _mm_set1_epi16(0xFF)); }
  static Reg odd(Reg a) { return _mm_srli_epi16(a, 8); }
  static Reg narrow(Reg a, Reg b) { return _mm_packus_epi16(a, b); }
  static Reg narrowSigns(Reg a, Reg b) { return _mm_packs_epi16(a, b); }
  static Reg lower(Reg a, Reg b) { return _mm_unpacklo_epi8(a, b); }
  static Reg upper(Reg a, Reg b) { return _mm_unpackhi_epi8(a, b); }
  static Reg products(Reg bytes, Reg factors) { return _mm_maddubs_epi16(bytes, factors); }
  static Reg plus16(Reg a, Reg b) { return _mm_adds_epi16(a, b); }

  static bool any(Reg a) { return _mm_movemask_epi8(a) != 0; }
  static Bits toBits(Reg a) { return static_cast<Bits>(_mm_movemask_epi8(a)); }
};

}  // namespace

const bool kHasClassifySsse3 = true;
void classifySsse3(const ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits) {
  classifyWith<Sixteen>(test, bgra, width, bits);
}
#else
const bool kHasClassifySsse3 = false;
void classifySsse3(const ColourTest&, const std::uint8_t*, int, std::uint64_t*) {}
#endif

}  // namespace darwinop::vision
