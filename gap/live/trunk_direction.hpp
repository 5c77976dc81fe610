// The direction of the trunk by its accelerometer.
#pragma once

#include <optional>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap::live {

/// Upward direction in the trunk's frame (left, up, forward), low-passed with kGravityTime.
class TrunkDirection {
 public:
  /// `accel_m_s2`: in the same frame. NaN: not read; nothing changes.
  void add(const Axes& accel_m_s2, double dt_s) noexcept;
  /// Unit vector; none before the first reading, and in free fall.
  [[nodiscard]] std::optional<Axes> up() const noexcept;
  /// The last reading agrees with it: the trunk does not turn.
  [[nodiscard]] bool isSteady() const noexcept;
  void forget() noexcept { mean_.reset(); }

 private:
  std::optional<Axes> mean_;
  Axes newest_{};
};

/// rad
double angleBetween(const Axes& a, const Axes& b) noexcept;

/// The nearest of the six directions along the trunk's axes if it is within kAlongAxis; else the same.
Axes alongAxis(const Axes& up) noexcept;

/// rad, by which a trunk on the floor pitches forward. None where it lies on its side, farther than kTurned.
std::optional<double> forwardLean(const Axes& up) noexcept;

}  // namespace darwinop::gap::live
