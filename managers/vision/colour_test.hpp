// Colour filter without divisions: comparisons of products of bytes, exact for every colour.
//
// With most, middle and least as the sorted channels, for each of the six orders of R, G, B:
//   saturation  floor(floor(255 (most - least) / most) 100 / 255) >= s  <=>  (255 - S) most >= 255 least,
//               where S = ceil(255 s / 100)
//   value       floor(100 most / 255) >= v                              <=>  most >= ceil(255 v / 100)
//   hue         60 k + t or 60 k - t, with t = floor(60 (middle - least) / (most - least)), 0..60; and
//               t >= n                                                  <=>  60 (middle - least) >= n (most - least)
// An arc of hues is a range of t in each order, or the complement of such a range.
#pragma once

#include <algorithm>
#include <cstdint>

#include "managers/vision/colour_filter.hpp"

namespace darwinop::vision {

/// Plain data without functions: it is included by files compiled for newer processors, whose code must not be shared
/// by the linker.
struct ColourTest {
  // Index R>=G | G>=B << 1 | B>=R << 2: first matching t and one past the last, negated because they are factors of a
  // sum. 16 bytes for a vector register.
  alignas(16) std::int8_t minus_first[16];
  alignas(16) std::int8_t minus_end[16];
  std::uint8_t least_most;         // minimum of `most`
  std::uint8_t least_factor_low;   // 255 - S in two halves, each a signed byte
  std::uint8_t least_factor_high;  //
  bool outside;                    // matches hues outside of the ranges of t
  bool grey;                       // matches grey
  bool nothing;                    // matches nothing
};

inline constexpr int kNever = 61;  // as first t: matches none of 0..60

ColourTest compile(const Thresholds&);

/// Equal to matches(toHsv(r, g, b), thresholds).
inline bool passes(const ColourTest& test, int r, int g, int b) {
  const int most = std::max({r, g, b}), least = std::min({r, g, b}), range = most - least;
  if (range == 0) return test.grey;
  if (test.nothing || most < test.least_most) return false;
  if ((test.least_factor_low + test.least_factor_high) * most < 255 * least) return false;
  const int order = int{r >= g} | int{g >= b} << 1 | int{b >= r} << 2;
  const int t60 = 60 * (r + g + b - most - least - least);
  const bool in = t60 + test.minus_first[order] * range >= 0 && t60 + test.minus_end[order] * range < 0;
  return in != test.outside;
}

}  // namespace darwinop::vision
