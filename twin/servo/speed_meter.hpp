// Present Speed register: encoder difference over the last 24 ms, therefore coarse and delayed. The window was measured
// on benches of this servo family.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace darwinop::twin {

class SpeedMeter {
 public:
  explicit SpeedMeter(double period_s)
      : positions_(static_cast<std::size_t>(std::max(1L, std::lround(kWindow / period_s)))),
        rate_1_s_{1 / (static_cast<double>(positions_.size()) * period_s)} {}

  void reset(double position_rad) noexcept {
    for (double& position : positions_) position = position_rad;
    speed_ = 0;
    next_ = 0;
  }

  void update(double position_rad) noexcept {
    speed_ = (position_rad - positions_[next_]) * rate_1_s_;
    positions_[next_] = position_rad;
    if (++next_ == positions_.size()) next_ = 0;
  }

  [[nodiscard]] double rad_s() const noexcept { return speed_; }

 private:
  static constexpr double kWindow = 0.024;  // s

  std::vector<double> positions_;
  double rate_1_s_;  // 1 / window
  std::size_t next_ = 0;
  double speed_ = 0;
};

}  // namespace darwinop::twin
