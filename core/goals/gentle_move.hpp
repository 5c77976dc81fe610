// Move from one pose to another on a cubic: all joints arrive together, at rest at both ends.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace darwinop::goals {

/// Angles in rad, times in ms. Allocates nothing.
template <std::size_t N>
class GentleMove {
 public:
  using Pose = std::array<double, N>;

  /// Peak speed, in the middle, as a multiple of the mean.
  static constexpr double kPeakPerMean = 1.5;

  GentleMove() = default;  // done
  GentleMove(const Pose& from, const Pose& to, double duration_ms) : from_{from}, to_{to}, duration_ms_{duration_ms} {}

  static double longestDistance(const Pose& from, const Pose& to) {
    double longest = 0;
    for (std::size_t i = 0; i < N; ++i) longest = std::max(longest, std::abs(to[i] - from[i]));
    return longest;
  }

  [[nodiscard]] double durationMs() const { return duration_ms_; }
  [[nodiscard]] double remainingMs() const { return duration_ms_ - time_ms_; }
  [[nodiscard]] bool done() const { return time_ms_ >= duration_ms_; }
  void advance(double ms) { time_ms_ = std::min(time_ms_ + ms, duration_ms_); }
  [[nodiscard]] double at(std::size_t joint) const {
    if (done()) return to_[joint];
    const double t = time_ms_ / duration_ms_;
    return from_[joint] + t * t * (3 - 2 * t) * (to_[joint] - from_[joint]);
  }

 private:
  Pose from_{}, to_{};
  double duration_ms_ = 0, time_ms_ = 0;
};

}  // namespace darwinop::goals
