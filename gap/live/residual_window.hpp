// Residuals of one signal over the last seconds.
#pragma once

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
    values_[next_] = residual;
    next_ = (next_ + 1) % values_.size();
    newest_ = residual;
    if (!(std::abs(residual) <= worst_) && !std::isnan(residual)) worst_ = std::abs(residual);
  }
  /// Summed again each time, so that no rounding error is left of values that have gone.
  [[nodiscard]] SignalResidual get() const noexcept {
    SignalResidual out{.newest = newest_, .rms = kNone, .worst = worst_, .count = 0};
    double sum = 0;
    for (const double value : values_)
      if (!std::isnan(value)) sum += value * value, ++out.count;
    if (out.count > 0) out.rms = std::sqrt(sum / static_cast<double>(out.count));
    return out;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values_;
  std::size_t next_ = 0;
  double newest_ = kNone, worst_ = kNone;
};

}  // namespace darwinop::gap::live
