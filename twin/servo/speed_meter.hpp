// Present speed as the servo tells it: the way of the encoder over the last 24 ms, so coarse and late. The window is
// that of benches of this servo family.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace darwinop::twin {

class SpeedMeter {
 public:
  explicit SpeedMeter(double period_s)
      : seen_(static_cast<std::size_t>(std::max(1L, std::lround(kWindow / period_s)))),
        rate_1_s_{1 / (static_cast<double>(seen_.size()) * period_s)} {}

  void reset(double position_rad) noexcept {
    for (double& seen : seen_) seen = position_rad;
    speed_ = 0;
    next_ = 0;
  }

  void see(double position_rad) noexcept {
    speed_ = (position_rad - seen_[next_]) * rate_1_s_;
    seen_[next_] = position_rad;
    if (++next_ == seen_.size()) next_ = 0;
  }

  [[nodiscard]] double rad_s() const noexcept { return speed_; }

 private:
  static constexpr double kWindow = 0.024;  // s

  std::vector<double> seen_;
  double rate_1_s_;  // one over the window
  std::size_t next_ = 0;
  double speed_ = 0;
};

}  // namespace darwinop::twin
