// Plane rows with SSE2, 16 pixels at a time.
#include "hal/pixels/plane_rows.hpp"

#ifdef __SSE2__
#include <emmintrin.h>

namespace darwinop::pixels {
namespace {

/// Eight pixels, the last pair first.
inline __m128i loadTurned(const std::uint8_t* yuyv) {
  return _mm_shuffle_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(yuyv)), _MM_SHUFFLE(0, 1, 2, 3));
}

inline __m128i evenBytes(__m128i a, __m128i b) {
  const __m128i mask = _mm_set1_epi16(0x00ff);
  return _mm_packus_epi16(_mm_and_si128(a, mask), _mm_and_si128(b, mask));
}

inline __m128i oddBytes(__m128i a, __m128i b) {
  return _mm_packus_epi16(_mm_srli_epi16(a, 8), _mm_srli_epi16(b, 8));
}

/// U V U V ... of 16 pixels.
inline __m128i chromaOf(const std::uint8_t* yuyv) {
  return oddBytes(loadTurned(yuyv + 16), loadTurned(yuyv));
}

}  // namespace

void lumaRowSse2(const std::uint8_t* yuyv, int width, std::uint8_t* y) noexcept {
  int left = width;  // pixels; an odd one is half a pair and ends the row
  if (left % 2 != 0) *y++ = yuyv[2 * --left];
  for (; left >= 16; left -= 16, y += 16) {
    const std::uint8_t* from = yuyv + 2 * (left - 16);
    const __m128i luma =
        evenBytes(loadTurned(from + 16), loadTurned(from));  // Y0 Y1 of each pair are still in camera order
    _mm_storeu_si128(reinterpret_cast<__m128i*>(y), _mm_or_si128(_mm_slli_epi16(luma, 8), _mm_srli_epi16(luma, 8)));
  }
  lumaRowScalar(yuyv, left, y);
}

void chromaRowSse2(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* u,
                   std::uint8_t* v) noexcept {
  int left = width;
  for (; left % 2 == 0 && left >= 16; left -= 16, u += 8, v += 8) {  // odd widths mix pairs; no camera has them
    const int at = 2 * (left - 16);
    const __m128i mean = _mm_avg_epu8(chromaOf(upper + at), chromaOf(lower + at));
    const __m128i planes = _mm_packus_epi16(_mm_and_si128(mean, _mm_set1_epi16(0x00ff)), _mm_srli_epi16(mean, 8));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(u), planes);
    _mm_storel_epi64(reinterpret_cast<__m128i*>(v), _mm_srli_si128(planes, 8));
  }
  chromaRowScalar(upper, lower, left, u, v);
}

}  // namespace darwinop::pixels
#endif
