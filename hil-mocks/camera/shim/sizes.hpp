// Picture sizes of the robot's camera and their maximum rates (thesis, table 4.1).
#pragma once

#include <linux/videodev2.h>

#include <cstdint>

namespace darwinop::hil::shim {

struct FrameSize {
  std::uint32_t width, height;
  v4l2_fract fastest;                                                   // interval between two frames, s
  constexpr std::uint32_t bytes() const { return 2 * width * height; }  // YUYV
};

inline constexpr FrameSize kSizes[] = {
    {320, 240, {1, 30}}, {640, 360, {1, 30}}, {640, 400, {1, 30}},
    {640, 480, {1, 30}}, {768, 480, {1, 28}}, {800, 600, {2, 45}},
};
inline constexpr std::uint32_t kSizeCount = sizeof kSizes / sizeof kSizes[0];

/// Intervals of a size: the fastest, then these.
inline constexpr v4l2_fract kSlowerIntervals[] = {{1, 15}, {1, 10}, {1, 5}};
inline constexpr std::uint32_t kIntervalCount = 1 + sizeof kSlowerIntervals / sizeof kSlowerIntervals[0];

constexpr v4l2_fract interval(const FrameSize& size, std::uint32_t index) {
  return index == 0 ? size.fastest : kSlowerIntervals[index - 1];
}
constexpr double seconds(v4l2_fract interval) {
  return static_cast<double>(interval.numerator) / static_cast<double>(interval.denominator);
}

/// As drivers do: the supported size whose sides differ least.
constexpr std::uint32_t nearestSize(std::uint32_t width, std::uint32_t height) {
  constexpr auto kApart = [](std::uint64_t a, std::uint64_t b) { return a > b ? a - b : b - a; };
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < kSizeCount; ++i)
    if (kApart(kSizes[i].width, width) + kApart(kSizes[i].height, height) <
        kApart(kSizes[best].width, width) + kApart(kSizes[best].height, height))
      best = i;
  return best;
}
static_assert(nearestSize(160, 120) == 0 && nearestSize(5000, 5000) == kSizeCount - 1 && nearestSize(640, 470) == 3);

constexpr v4l2_fract nearestInterval(const FrameSize& size, v4l2_fract wanted) {
  if (wanted.numerator == 0 || wanted.denominator == 0) return size.fastest;  // request for the default
  constexpr auto kApart = [](double a, double b) { return a > b ? a - b : b - a; };
  v4l2_fract best = size.fastest;
  for (std::uint32_t i = 1; i < kIntervalCount; ++i)
    if (kApart(seconds(interval(size, i)), seconds(wanted)) < kApart(seconds(best), seconds(wanted)))
      best = interval(size, i);
  return best;
}
static_assert(nearestInterval(kSizes[5], {1, 30}).denominator == 45);

}  // namespace darwinop::hil::shim
