// AVX2 colour filter, 32 pixels at a time (Intel and AMD processors since about 2015).
#include "managers/vision/classify.hpp"

#ifdef __AVX2__
#include <immintrin.h>

#include "managers/vision/classify_kernel.hpp"
#endif

namespace darwinop::vision {

#ifdef __AVX2__
namespace {

struct ThirtyTwo {
  using Reg = __m256i;
  using Bits = std::uint32_t;
  static constexpr int kBytes = 32;

  static Reg load(const std::uint8_t* from) { return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)); }
  static Reg table(const std::int8_t* of_16) {
    return _mm256_broadcastsi128_si256(_mm_load_si128(reinterpret_cast<const __m128i*>(of_16)));
  }
  static Reg all(int byte) { return _mm256_set1_epi8(static_cast<char>(byte)); }
  static Reg all16(int low, int high) { return _mm256_set1_epi16(static_cast<short>((low & 0xFF) | high * 256)); }
  static Reg zero() { return _mm256_setzero_si256(); }
  static Reg ones() { return _mm256_set1_epi8(-1); }

  static Reg both(Reg a, Reg b) { return _mm256_and_si256(a, b); }
  static Reg either(Reg a, Reg b) { return _mm256_or_si256(a, b); }
  static Reg unlike(Reg a, Reg b) { return _mm256_xor_si256(a, b); }
  static Reg butNot(Reg a, Reg b) { return _mm256_andnot_si256(b, a); }

  static Reg min(Reg a, Reg b) { return _mm256_min_epu8(a, b); }
  static Reg max(Reg a, Reg b) { return _mm256_max_epu8(a, b); }
  static Reg minus(Reg a, Reg b) { return _mm256_sub_epi8(a, b); }
  static Reg equal(Reg a, Reg b) { return _mm256_cmpeq_epi8(a, b); }
  static Reg notLess(Reg a, Reg b) { return equal(max(a, b), a); }
  static Reg more(Reg a, Reg b) { return _mm256_cmpgt_epi8(a, b); }  // signed
  static Reg lookUp(Reg table, Reg index) { return _mm256_shuffle_epi8(table, index); }

  static Reg even(Reg a) { return both(a, _mm256_set1_epi16(0xFF)); }
  static Reg odd(Reg a) { return _mm256_srli_epi16(a, 8); }
  static Reg narrow(Reg a, Reg b) { return _mm256_packus_epi16(a, b); }
  static Reg narrowSigns(Reg a, Reg b) { return _mm256_packs_epi16(a, b); }
  static Reg lower(Reg a, Reg b) { return _mm256_unpacklo_epi8(a, b); }
  static Reg upper(Reg a, Reg b) { return _mm256_unpackhi_epi8(a, b); }
  static Reg products(Reg bytes, Reg factors) { return _mm256_maddubs_epi16(bytes, factors); }
  static Reg plus16(Reg a, Reg b) { return _mm256_adds_epi16(a, b); }

  static bool any(Reg a) { return _mm256_movemask_epi8(a) != 0; }
  /// Two narrowings leave groups of four pixels in the order 0 2 4 6 1 3 5 7.
  static Bits toBits(Reg a) {
    const Reg in_order = _mm256_permutevar8x32_epi32(a, _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
    return static_cast<Bits>(_mm256_movemask_epi8(in_order));
  }
};

}  // namespace

const bool kHasClassifyAvx2 = true;
void classifyAvx2(const ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits) {
  classifyWith<ThirtyTwo>(test, bgra, width, bits);
}
#else
const bool kHasClassifyAvx2 = false;
void classifyAvx2(const ColourTest&, const std::uint8_t*, int, std::uint64_t*) {}
#endif

}  // namespace darwinop::vision
