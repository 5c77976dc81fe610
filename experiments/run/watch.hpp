// Ends of phases that the robot decides: joints arrived, joints at rest, the robot has fallen.
#pragma once

#include <array>

#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {

using Positions = std::array<double, kJoints>;  // rad, NaN: not known

/// From the counts of the accelerometer, 128 a g, upright 512, 512, 640.
class FallWatch {
 public:
  /// `counts`: three values, NaN while not known.
  void update(const double* counts, double dt_s);
  /// The trunk is tilted by more than 45 degrees, for a quarter of a second. Blows and free fall, in which the
  /// accelerometer cannot tell where down is, do not count.
  [[nodiscard]] bool fallen() const { return tilted_s_ >= 0.25; }

 private:
  double tilted_s_ = 0;
};

/// One phase.
class EndWatch {
 public:
  EndWatch(const Phase& phase, const Positions& begin) : phase_{phase}, begin_{begin}, still_{begin} {}

  /// `t`: seconds since the phase began.
  [[nodiscard]] bool over(const Positions& seen, bool fallen, double t);

 private:
  [[nodiscard]] bool arrived(const Positions& seen) const;
  [[nodiscard]] bool resting(const Positions& seen, double t);

  const Phase& phase_;
  Positions begin_, still_;
  double still_since_ = 0;
};

}  // namespace darwinop::experiments
