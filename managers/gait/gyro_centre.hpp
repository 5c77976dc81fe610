// Calibrates the zero of the gyroscope's two balance axes while the robot stands still.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "managers/gait/balance.hpp"

namespace darwinop::gait {

/// Source: the ROBOTIS engine: 100 samples with standard deviations below 2 counts. Different here: every sample is a
/// new reading, 16 ms apart on a robot (there 8 ms); a mean of 70 deg/s or more is rejected, because the robot is being
/// turned.
class GyroCentre {
 public:
  static constexpr int kSamples = 100;
  static constexpr double kStillCounts = 2;
  static constexpr double kMiddle = 512, kMaxOffset = 20;  // counts

  /// Raw counts; NaN is ignored. Restarts if 100 samples do not meet the criteria.
  void add(double roll, double pitch) {
    if (centre_ || !std::isfinite(roll) || !std::isfinite(pitch)) return;
    roll_[count_] = roll;
    pitch_[count_] = pitch;
    if (++count_ < kSamples) return;
    count_ = 0;
    const Spread roll_spread = spreadOf(roll_), pitch_spread = spreadOf(pitch_);
    if (roll_spread.isRest() && pitch_spread.isRest()) centre_ = Tilt{roll_spread.mean, pitch_spread.mean};
  }

  /// Discards samples, e.g. from before the robot stood still; keeps a known centre.
  void restart() { count_ = 0; }

  [[nodiscard]] bool known() const { return centre_.has_value(); }
  /// Raw counts relative to the centre; NaN while it is unknown.
  [[nodiscard]] Tilt tilt(double roll, double pitch) const {
    if (!centre_) return {std::nan(""), std::nan("")};
    return {roll - centre_->roll, pitch - centre_->pitch};
  }

 private:
  using Samples = std::array<double, kSamples>;
  struct Spread {
    double mean, deviation;
    [[nodiscard]] bool isRest() const { return deviation < kStillCounts && std::abs(mean - kMiddle) < kMaxOffset; }
  };

  static Spread spreadOf(const Samples& samples) {
    double sum = 0, squares = 0;
    for (double sample : samples) sum += sample;
    const double mean = sum / kSamples;
    for (double sample : samples) squares += (sample - mean) * (sample - mean);
    return {mean, std::sqrt(squares / kSamples)};
  }

  Samples roll_{}, pitch_{};
  std::size_t count_ = 0;
  std::optional<Tilt> centre_;
};

}  // namespace darwinop::gait
