// Compiles thresholds to a ColourTest.
#include "managers/vision/colour_test.hpp"

namespace darwinop::vision {

namespace {

/// An order of R, G and B (index as in ColourTest) with its hue at t: base + sign t.
struct Order {
  int index, base, sign;
};
constexpr Order kOrders[] = {{3, 0, 1}, {2, 120, -1}, {6, 120, 1}, {4, 240, -1}, {5, 240, 1}, {1, 360, -1}};

/// The smallest byte whose truncated percentage of 255 exceeds `minimum`; 256 or more: none.
int byteAbove(int minimum) {
  const int percent = std::clamp(minimum, -1, 100) + 1;
  return (255 * percent + 99) / 100;
}

/// Sets the ranges of t whose hues are in the arc (or not in it, for `outside`). False if they are not contiguous.
bool setRanges(ColourTest& test, const HueArc& arc, bool outside) {
  test.outside = outside;
  for (int i = 0; i < 16; ++i) {
    test.minus_first[i] = -kNever;
    test.minus_end[i] = -kNever;
  }
  for (const Order& order : kOrders) {
    int first = kNever, end = kNever, count = 0;
    for (int t = 0; t <= 60; ++t) {
      if (arc.contains((order.base + order.sign * t) % 360) == outside) continue;
      if (count++ == 0) first = t;
      end = t + 1;
    }
    if (count > 0 && end - first != count) return false;
    test.minus_first[order.index] = static_cast<std::int8_t>(-first);
    test.minus_end[order.index] = static_cast<std::int8_t>(-end);
  }
  return true;
}

}  // namespace

ColourTest compile(const Thresholds& wanted) {
  const HueArc arc{wanted};
  ColourTest test{};
  // If the arc has two ranges in one order, its complement is shorter than 60 degrees and contiguous in every order.
  if (!setRanges(test, arc, false)) setRanges(test, arc, true);
  const int most = byteAbove(wanted.min_value), saturation = byteAbove(wanted.min_saturation);
  test.grey = wanted.min_saturation < 0 && wanted.min_value < 0 && arc.contains(kNoHue % 360);
  test.nothing = most > 255 || saturation > 255;
  if (test.nothing) return test;
  test.least_most = static_cast<std::uint8_t>(most);
  // Two signed bytes hold at most 254. For "any saturation" (255) this is equivalent: least is at most most - 1, and
  // 254 most >= 255 (most - 1) for every byte.
  const int factor = std::min(255 - saturation, 254);
  test.least_factor_low = static_cast<std::uint8_t>(factor / 2);
  test.least_factor_high = static_cast<std::uint8_t>(factor - factor / 2);
  return test;
}

}  // namespace darwinop::vision
