// BGRA rows with SSE2, SSSE3 (the highest level of the robot's Atom) and AVX2: 8 or 16 pixels at a time.
//
// 256 Y has no bits below the shift, so (256 Y + c) >> 8 is Y + (c >> 8): the chroma term is computed once per pair,
// and Y is added in 16 bits without overflow. With the chroma in the upper byte of a word, pmulhw multiplies and shifts
// by 8 exactly; green sums two products that together exceed 16 bits, which pmaddwd computes in 32.
#include "hal/pixels/bgra_rows.hpp"

#ifdef __SSE2__
#include <immintrin.h>

namespace darwinop::pixels {
namespace {

/// Two words in each 32 bits, U first: a pair of pixels occupies 32 bits throughout.
constexpr int words(int for_u, int for_v) {
  return static_cast<int>((for_v & 0xffffU) << 16 | (for_u & 0xffffU));
}

constexpr int kBlueRed = words(kBlueU, kRedV), kGreen = words(kGreenU, kGreenV);
constexpr int kLumaMask = words(0x00ff, 0x00ff), kChromaMask = words(0xff00, 0xff00), kMiddle = words(0x8000, 0x8000);

/// Chroma term of a pair: blue in the lower, red in the upper word; green in the upper word.
struct Added {
  __m128i blue_red, green;
};

inline Added addedBy(__m128i yuyv) {
  const __m128i chroma =
      _mm_xor_si128(_mm_and_si128(yuyv, _mm_set1_epi32(kChromaMask)), _mm_set1_epi32(kMiddle));  // 256 u, 256 v
  return {_mm_mulhi_epi16(chroma, _mm_set1_epi32(kBlueRed)), _mm_madd_epi16(chroma, _mm_set1_epi32(kGreen))};
}

inline __m128i lumaOf(__m128i yuyv) {
  return _mm_and_si128(yuyv, _mm_set1_epi32(kLumaMask));
}

/// Words of eight pixels; packing saturates to 0..255.
inline void put(__m128i luma, __m128i blue, __m128i green, __m128i red, std::uint8_t* bgra) {
  const __m128i br = _mm_packus_epi16(_mm_add_epi16(luma, blue), _mm_add_epi16(luma, red));
  const __m128i ga = _mm_packus_epi16(_mm_add_epi16(luma, green), _mm_set1_epi16(255));
  const __m128i bg = _mm_unpacklo_epi8(br, ga), ra = _mm_unpackhi_epi8(br, ga);
  auto* to = reinterpret_cast<__m128i*>(bgra);
  _mm_storeu_si128(to, _mm_unpacklo_epi16(bg, ra));
  _mm_storeu_si128(to + 1, _mm_unpackhi_epi16(bg, ra));
}

inline __m128i load(const std::uint8_t* yuyv) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(yuyv));
}

/// Picks words out of every four.
template <int order>
__m128i picked(__m128i words) {
  return _mm_shufflehi_epi16(_mm_shufflelo_epi16(words, order), order);
}
constexpr int kSwapped = _MM_SHUFFLE(2, 3, 0, 1), kLower = _MM_SHUFFLE(2, 2, 0, 0), kUpper = _MM_SHUFFLE(3, 3, 1, 1);

}  // namespace

void bgraRowSse2(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept {
  bgra = putOddBgra(yuyv, width, bgra);
  int left = width / 2 * 2;  // pixels
  for (; left >= 8; left -= 8, bgra += 32) {
    const __m128i turned = _mm_shuffle_epi32(load(yuyv + 2 * (left - 8)), _MM_SHUFFLE(0, 1, 2, 3));
    const Added added = addedBy(turned);
    put(picked<kSwapped>(lumaOf(turned)), picked<kLower>(added.blue_red), picked<kUpper>(added.green),
        picked<kUpper>(added.blue_red), bgra);
  }
  bgraRowScalar(yuyv, left, bgra);
}

__attribute__((target("ssse3"))) void bgraRowSsse3(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept {
  const __m128i turn = _mm_setr_epi8(14, 13, 12, 15, 10, 9, 8, 11, 6, 5, 4, 7, 2, 1, 0, 3);
  const __m128i lower = _mm_setr_epi8(0, 1, 0, 1, 4, 5, 4, 5, 8, 9, 8, 9, 12, 13, 12, 13);
  const __m128i upper = _mm_setr_epi8(2, 3, 2, 3, 6, 7, 6, 7, 10, 11, 10, 11, 14, 15, 14, 15);
  bgra = putOddBgra(yuyv, width, bgra);
  int left = width / 2 * 2;
  for (; left >= 8; left -= 8, bgra += 32) {
    const __m128i turned = _mm_shuffle_epi8(load(yuyv + 2 * (left - 8)), turn);
    const Added added = addedBy(turned);
    put(lumaOf(turned), _mm_shuffle_epi8(added.blue_red, lower), _mm_shuffle_epi8(added.green, upper),
        _mm_shuffle_epi8(added.blue_red, upper), bgra);
  }
  bgraRowScalar(yuyv, left, bgra);
}

// The same, 16 pixels wide. Most AVX2 instructions work on each 128-bit lane, so the quarters are arranged such that
// the final interleave restores pixel order.
__attribute__((target("avx2"))) void bgraRowAvx2(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept {
  const __m256i turn = _mm256_broadcastsi128_si256(_mm_setr_epi8(6, 5, 4, 7, 2, 1, 0, 3, 14, 13, 12, 15, 10, 9, 8, 11));
  const __m256i lower = _mm256_broadcastsi128_si256(_mm_setr_epi8(0, 1, 0, 1, 4, 5, 4, 5, 8, 9, 8, 9, 12, 13, 12, 13));
  const __m256i upper =
      _mm256_broadcastsi128_si256(_mm_setr_epi8(2, 3, 2, 3, 6, 7, 6, 7, 10, 11, 10, 11, 14, 15, 14, 15));
  bgra = putOddBgra(yuyv, width, bgra);
  int left = width / 2 * 2;
  for (; left >= 16; left -= 16, bgra += 64) {
    const auto* from = reinterpret_cast<const __m256i*>(yuyv + 2 * (left - 16));
    const __m256i quarters = _mm256_permute4x64_epi64(_mm256_loadu_si256(from), _MM_SHUFFLE(0, 2, 1, 3));
    const __m256i turned = _mm256_shuffle_epi8(quarters, turn);
    const __m256i luma = _mm256_and_si256(turned, _mm256_set1_epi32(kLumaMask));
    const __m256i chroma =
        _mm256_xor_si256(_mm256_and_si256(turned, _mm256_set1_epi32(kChromaMask)), _mm256_set1_epi32(kMiddle));
    const __m256i blue_red = _mm256_mulhi_epi16(chroma, _mm256_set1_epi32(kBlueRed));
    const __m256i green = _mm256_madd_epi16(chroma, _mm256_set1_epi32(kGreen));
    const __m256i br = _mm256_packus_epi16(_mm256_add_epi16(luma, _mm256_shuffle_epi8(blue_red, lower)),
                                           _mm256_add_epi16(luma, _mm256_shuffle_epi8(blue_red, upper)));
    const __m256i ga =
        _mm256_packus_epi16(_mm256_add_epi16(luma, _mm256_shuffle_epi8(green, upper)), _mm256_set1_epi16(255));
    const __m256i bg = _mm256_unpacklo_epi8(br, ga), ra = _mm256_unpackhi_epi8(br, ga);
    auto* to = reinterpret_cast<__m256i*>(bgra);
    _mm256_storeu_si256(to, _mm256_unpacklo_epi16(bg, ra));
    _mm256_storeu_si256(to + 1, _mm256_unpackhi_epi16(bg, ra));
  }
  bgraRowSse2(yuyv, left, bgra);
}

}  // namespace darwinop::pixels
#endif
