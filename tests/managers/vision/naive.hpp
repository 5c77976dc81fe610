// The colour finder straight from its rules, a pixel at a time and without a thought to speed: what ours is held to.
// It shares no line with it.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace darwinop::vision::naive {

struct Colour {
  int hue, saturation, value;
};

inline Colour convert(int r, int g, int b) {
  int max = r, min = r;
  if (g > max) max = g;
  if (b > max) max = b;
  if (g < min) min = g;
  if (b < min) min = b;
  const int d = max - min;
  if (max == 0 || d == 0) return {65535, 0, 0};
  int h = 0;
  if (max == r)
    h = (60 * (g - b)) / d;
  else if (max == g)
    h = 120 + (60 * (b - r)) / d;
  else
    h = 240 + (60 * (r - g)) / d;
  if (h < 0) h += 360;
  const int s0 = 255 * d / max;
  return {h, s0 * 100 / 255, max * 100 / 255};
}

struct Rule {
  int hue = 356, tolerance = 15, min_saturation = 50, min_value = 10;
};

inline bool passes(const Colour& c, const Rule& rule) {
  int hi = rule.hue + rule.tolerance;
  if (hi > 360) hi -= 360;
  int lo = rule.hue - rule.tolerance;
  if (lo < 0) lo += 360;
  int h = c.hue;
  if (h > 360) h %= 360;
  if (!(c.saturation > rule.min_saturation)) return false;
  if (!(c.value > rule.min_value)) return false;
  if (lo <= hi) return lo < h && h < hi;
  return h > lo || h < hi;
}

struct Mask {
  int width, height;
  std::vector<char> set = std::vector<char>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool at(int x, int y) const { return set[place(x, y)] != 0; }
};

/// Each pixel but the border's: whether `wanted` of its nine neighbours, itself among them, are set.
inline Mask nine(const Mask& from, int wanted) {
  Mask to{from.width, from.height};
  for (int y = 1; y < from.height - 1; ++y)
    for (int x = 1; x < from.width - 1; ++x) {
      int count = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) count += from.at(x + dx, y + dy) ? 1 : 0;
      to.set[to.place(x, y)] = count >= wanted;
    }
  return to;
}

inline Mask erode(const Mask& from) {
  return nine(from, 9);
}
inline Mask dilate(const Mask& from) {
  return nine(from, 1);
}

struct Result {
  bool found = false;
  int x = -1, y = -1;
  Mask mask;
};

inline Result centre(const Mask& mask, double min_percent, double max_percent) {
  Result result{.mask = mask};
  std::uint64_t n = 0, sum_x = 0, sum_y = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (!mask.at(x, y)) continue;
      ++n;
      sum_x += static_cast<unsigned>(x);
      sum_y += static_cast<unsigned>(y);
    }
  const double area = static_cast<double>(mask.width) * mask.height, count = static_cast<double>(n);
  if (n == 0 || count <= area * min_percent / 100 || count > area * max_percent / 100) return result;
  result.found = true;
  result.x = static_cast<int>(sum_x / n);
  result.y = static_cast<int>(sum_y / n);
  return result;
}

inline Mask filter(const std::uint8_t* bgra, int width, int height, const Rule& rule) {
  Mask mask{width, height};
  for (std::size_t i = 0; i < mask.set.size(); ++i)
    mask.set[i] = passes(convert(bgra[4 * i + 2], bgra[4 * i + 1], bgra[4 * i]), rule);
  return mask;
}

inline Result find(const std::uint8_t* bgra, int width, int height, const Rule& rule, double min_percent,
                   double max_percent) {
  return centre(dilate(erode(filter(bgra, width, height, rule))), min_percent, max_percent);
}

}  // namespace darwinop::vision::naive
