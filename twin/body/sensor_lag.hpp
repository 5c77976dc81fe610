// Filter and delay of the inertial sensors.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace darwinop::twin {

/// Share of the distance to its input by which a first-order low-pass moves in `step_s`.
inline double lowpassShare(double step_s, double time_s) noexcept {
  return 1 - std::exp(-step_s / time_s);
}

/// Three signals as a slow sensor has them: low-pass, then delay, with linear interpolation between steps.
class SensorLag {
 public:
  using Values = std::array<double, 3>;

  /// 0: no filter; no delay. Allocates.
  SensorLag(double step_s, double lowpass_s, double delay_s)
      : share_{lowpass_s > 0 ? lowpassShare(step_s, lowpass_s) : 1}, late_{delay_s / step_s} {
    past_.resize(static_cast<std::size_t>(late_) + 2);
  }
  [[nodiscard]] bool acts() const noexcept { return share_ < 1 || late_ > 0; }

  /// As if it had always been so.
  void fill(const Values& values) noexcept {
    filtered_ = values;
    for (Values& past : past_) past = values;
  }
  void next(const Values& values) noexcept {
    for (std::size_t i = 0; i < values.size(); ++i) filtered_[i] += share_ * (values[i] - filtered_[i]);
    head_ = (head_ + 1) % past_.size();
    past_[head_] = filtered_;
  }
  [[nodiscard]] Values now() const noexcept {
    const double whole = std::floor(late_), part = late_ - whole;
    Values out = ago(static_cast<std::size_t>(whole));
    if (part > 0) {
      const Values& before = ago(static_cast<std::size_t>(whole) + 1);
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += part * (before[i] - out[i]);
    }
    return out;
  }

 private:
  [[nodiscard]] const Values& ago(std::size_t steps) const noexcept {
    return past_[(head_ + past_.size() - steps) % past_.size()];
  }

  double share_, late_;  // late: in steps
  Values filtered_{};
  std::vector<Values> past_;  // the newest at head_
  std::size_t head_ = 0;
};

}  // namespace darwinop::twin
