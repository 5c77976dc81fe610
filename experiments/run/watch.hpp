// End conditions of phases: joints arrived, joints at rest, robot fallen.
#pragma once

#include <array>

#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {

using Positions = std::array<double, kJoints>;  // rad, NaN: unknown

/// Fall detection from accelerometer counts: 128 per g, upright 512, 512, 640.
class FallWatch {
 public:
  /// `counts`: three values, NaN while unknown.
  void update(const double* counts, double dt_s);
  /// The trunk has been tilted by more than 45 degrees for 0.25 s. Samples outside 0.5 to 1.5 g (impacts, free fall)
  /// are ignored.
  [[nodiscard]] bool fallen() const { return tilted_s_ >= 0.25; }

 private:
  double tilted_s_ = 0;
};

/// End condition of one phase.
class EndWatch {
 public:
  EndWatch(const Phase& phase, const Positions& begin) : phase_{phase}, begin_{begin}, rest_position_{begin} {}

  /// `t`: seconds since the phase began.
  [[nodiscard]] bool isOver(const Positions& seen, bool fallen, double t);

 private:
  [[nodiscard]] bool arrived(const Positions& seen) const;
  [[nodiscard]] bool resting(const Positions& seen, double t);

  const Phase& phase_;
  Positions begin_, rest_position_;
  double rest_since_ = 0;
};

}  // namespace darwinop::experiments
