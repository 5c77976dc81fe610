// Sine of a slowly changing angle by Taylor expansion: std::sin() took a fifth of the simulation time.
#pragma once

#include <cmath>

namespace darwinop::twin {

/// Expands about the last angle evaluated with std::sin(); error below 1e-16.
class NearSine {
 public:
  double operator()(double angle_rad) noexcept {
    double d = angle_rad - at_;
    if (std::abs(d) > kNear) {
      at_ = angle_rad;
      sine_ = std::sin(angle_rad);
      cosine_ = std::cos(angle_rad);
      d = 0;
    }
    const double d2 = d * d;
    // Multiplications by reciprocals: the compiler may not replace divisions itself.
    const double sine = d - d * d2 * (1.0 / 6 - d2 * (1.0 / 120 - d2 * (1.0 / 5040)));
    const double cosine = 1 - d2 * (1.0 / 2 - d2 * (1.0 / 24 - d2 * (1.0 / 720)));
    return sine_ * cosine + cosine_ * sine;
  }

 private:
  static constexpr double kNear = 1.0 / 64;  // rad: the next terms are d^9 / 9! and d^8 / 8!

  double at_ = 0, sine_ = 0, cosine_ = 1;
};

}  // namespace darwinop::twin
