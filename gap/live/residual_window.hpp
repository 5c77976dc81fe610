// Residuals of one signal over the last seconds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace darwinop::gap::live {

/// NaN: nothing was compared.
struct SignalResidual {
  double newest = std::numeric_limits<double>::quiet_NaN();
  double rms = newest;    // over the window
  double worst = newest;  // greatest absolute one since the begin
  std::size_t count = 0;  // in the window
};

class ResidualWindow {
 public:
  explicit ResidualWindow(std::size_t cycles) : values_(cycles, kNone) {}

  /// NaN: not compared in this cycle. Allocates nothing.
  void add(double residual) noexcept {
    worst_before_ = greater(worst_before_, values_[next_]);
    values_[next_] = residual;
    next_ = (next_ + 1) % values_.size();
    newest_ = residual;
  }
  /// The last cycles, at most the window, count as not compared.
  void forgetLast(std::size_t cycles) noexcept {
    const std::size_t size = values_.size();
    for (std::size_t i = 1; i <= std::min(cycles, size); ++i) values_[(next_ + size - i) % size] = kNone;
    newest_ = kNone;
  }
  /// Summed again each time, so that no rounding error is left of values that have gone.
  [[nodiscard]] SignalResidual get() const noexcept {
    SignalResidual out{.newest = newest_, .rms = kNone, .worst = worst_before_, .count = 0};
    double sum = 0;
    for (const double value : values_) {
      if (!std::isnan(value)) sum += value * value, ++out.count;
      out.worst = greater(out.worst, value);
    }
    if (out.count > 0) out.rms = std::sqrt(sum / static_cast<double>(out.count));
    return out;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  static double greater(double worst, double residual) noexcept {
    return std::abs(residual) <= worst || std::isnan(residual) ? worst : std::abs(residual);
  }

  std::vector<double> values_;
  std::size_t next_ = 0;
  double newest_ = kNone, worst_before_ = kNone;  // before the window
};

}  // namespace darwinop::gap::live
