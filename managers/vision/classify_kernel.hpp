// SIMD kernel of the colour filter. Included by files compiled for newer processors, so it must not call shared inline
// functions: the linker would keep one copy for all.
#pragma once

#include <string.h>

#include <cstdint>

#include "managers/vision/colour_test.hpp"

namespace darwinop::vision {

/// V: register of bytes in lanes of 16; widening and narrowing stay within a lane.
template <class V>
class ClassifyKernel {
  using Reg = typename V::Reg;

 public:
  static constexpr int kPixels = V::kBytes;

  explicit ClassifyKernel(const ColourTest& test)
      : first_{V::table(test.minus_first)},
        end_{V::table(test.minus_end)},
        most_{V::all(test.least_most)},
        factors_low_{V::all16(test.least_factor_low, -127)},
        factors_high_{V::all16(test.least_factor_high, -128)},
        outside_{V::all(test.outside ? 0xFF : 0)},
        grey_{V::all(test.grey ? 0xFF : 0)} {}

  /// kPixels pixels, 4 bytes each.
  [[nodiscard]] typename V::Bits bits(const std::uint8_t* bgra) const {
    const Reg p0 = V::load(bgra), p1 = V::load(bgra + V::kBytes);
    const Reg p2 = V::load(bgra + 2 * V::kBytes), p3 = V::load(bgra + 3 * V::kBytes);
    // Even bytes of 16-bit words are blue and red alternately, odd bytes green and alpha.
    const Reg br01 = V::narrow(V::even(p0), V::even(p1)), br23 = V::narrow(V::even(p2), V::even(p3));
    const Reg ga01 = V::narrow(V::odd(p0), V::odd(p1)), ga23 = V::narrow(V::odd(p2), V::odd(p3));
    const Reg b = V::narrow(V::even(br01), V::even(br23)), r = V::narrow(V::odd(br01), V::odd(br23));
    const Reg g = V::narrow(V::even(ga01), V::even(ga23));

    const Reg low = V::min(r, g), high = V::max(r, g);
    const Reg least = V::min(low, b), most = V::max(high, b), middle = V::max(low, V::min(high, b));
    const Reg range = V::minus(most, least);
    const Reg is_grey = V::equal(range, V::zero());
    const Reg order = V::either(V::either(V::both(V::equal(high, r), V::all(1)), V::both(V::notLess(g, b), V::all(2))),
                                V::both(V::notLess(b, r), V::all(4)));
    const Reg first = V::lookUp(first_, order);
    // Early exit if no pixel has the right hue and value, which is the usual case.
    const Reg may_be = V::both(V::notLess(most, most_), V::either(V::more(first, V::all(-kNever)), outside_));
    const Reg grey = V::both(is_grey, grey_);
    if (!V::any(may_be)) return V::toBits(grey);

    const Reg end = V::lookUp(end_, order), sixty = V::all(60), part = V::minus(middle, least);
    const Reg low_bad = bad(V::lower(part, range), V::lower(sixty, first), V::lower(sixty, end), V::lower(most, least));
    const Reg high_bad =
        bad(V::upper(part, range), V::upper(sixty, first), V::upper(sixty, end), V::upper(most, least));
    // From here on only the highest bit of each byte is significant.
    const Reg good = V::butNot(may_be, V::either(V::narrowSigns(low_bad, high_bad), is_grey));
    return V::toBits(V::either(good, grey));
  }

 private:
  /// Negative 16-bit words where saturation or hue do not match.
  [[nodiscard]] Reg bad(Reg part_range, Reg sixty_first, Reg sixty_end, Reg most_least) const {
    const Reg before_first = V::products(part_range, sixty_first), before_end = V::products(part_range, sixty_end);
    const Reg hue = V::unlike(V::butNot(V::ones(), V::butNot(before_end, before_first)), outside_);
    const Reg saturation = V::plus16(V::products(most_least, factors_low_), V::products(most_least, factors_high_));
    return V::either(hue, saturation);
  }

  Reg first_, end_, most_, factors_low_, factors_high_, outside_, grey_;
};

template <class V>
void classifyWith(const ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits) {
  const ClassifyKernel<V> kernel{test};
  constexpr int kPixels = ClassifyKernel<V>::kPixels;
  int x = 0;
  for (; x + 64 <= width; x += 64) {
    std::uint64_t word = 0;
    for (int part = 0; part < 64; part += kPixels, bgra += 4 * kPixels)
      word |= static_cast<std::uint64_t>(kernel.bits(bgra)) << part;
    *bits++ = word;
  }
  if (x == width) return;
  std::uint64_t word = 0;
  for (int part = 0; x < width; part += kPixels, x += kPixels, bgra += 4 * kPixels) {
    const int count = width - x;
    if (count >= kPixels) {
      word |= static_cast<std::uint64_t>(kernel.bits(bgra)) << part;
    } else {  // must not read beyond the row, which may be the last one
      std::uint8_t rest[4 * kPixels] = {};
      memcpy(rest, bgra, static_cast<unsigned>(4 * count));
      word |= (static_cast<std::uint64_t>(kernel.bits(rest)) & ((std::uint64_t{1} << count) - 1)) << part;
    }
  }
  *bits = word;
}

}  // namespace darwinop::vision
