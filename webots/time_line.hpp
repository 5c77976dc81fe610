// Maps the steps of a controller to cycles of the loop.
#pragma once

#include <cstdint>

#include "hal/byte_line.hpp"

namespace darwinop::webots_api {

/// Absolute times: steps add up exactly, so a step that is not a multiple of the period keeps its mean rate.
class TimeLine {
 public:
  TimeLine() = default;
  TimeLine(Nanos period, std::uint64_t cycle) : period_{period}, origin_{cycle} {}

  /// The cycle that ends a step of this length; the same cycle again if steps are shorter than the period.
  std::uint64_t advance(Nanos step) {
    due_ += step;
    return origin_ + static_cast<std::uint64_t>((due_ + period_ - Nanos{1}) / period_);
  }

  /// Restarts: the next step counts from the end of `cycle`.
  void restartAt(std::uint64_t cycle) {
    origin_ = cycle;
    due_ = Nanos{0};
  }

  [[nodiscard]] Nanos period() const { return period_; }

 private:
  Nanos period_{1};
  std::uint64_t origin_ = 0;
  Nanos due_{0};
};

}  // namespace darwinop::webots_api
