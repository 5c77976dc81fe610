// Goal trajectories.
#include "experiments/format/shape.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace darwinop::experiments {
namespace {

double stepsAt(const Goal& goal, double t) {
  std::size_t i = 0;
  for (double next = goal.every_s.front(); t >= next && i + 1 < goal.goals.size();)
    next += goal.every_s[std::min(++i, goal.every_s.size() - 1)];
  return goal.goals[i];
}

/// Triangle wave of amplitude 1, starting at 0 and rising; `periods` is time / period.
double triangle(double periods) {
  const double phase = periods - std::floor(periods);
  return phase < 0.25 ? 4 * phase : phase < 0.75 ? 2 - 4 * phase : 4 * phase - 4;
}

/// Linear chirp from hz[0] to hz[1].
double chirp(const Goal& goal, double duration_s, double t) {
  const double rise = (goal.hz[1] - goal.hz[0]) / duration_s;
  return std::sin(2 * kPi * (goal.hz[0] + rise * t / 2) * t);
}

/// Sum of sines with equal amplitudes and alternating signs, normalized to at most 1.
double multisine(const Goal& goal, double t) {
  double sum = 0, sign = 1;
  for (const double hz : goal.hz) {
    sum += sign * std::sin(2 * kPi * hz * t);
    sign = -sign;
  }
  return sum / static_cast<double>(goal.hz.size());
}

double swing(const Goal& goal, double duration_s, double t) {
  switch (goal.shape) {
    case Shape::kTriangle:
      return triangle(t / goal.period_s);
    case Shape::kSine:
      return std::sin(2 * kPi * goal.hz[0] * t);
    case Shape::kChirp:
      return chirp(goal, duration_s, t);
    default:
      return multisine(goal, t);
  }
}

}  // namespace

double smooth(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

double goalAt(const Goal& goal, double duration_s, double sign, double begin, double t) {
  t = std::clamp(t, 0.0, duration_s);
  const double distance = sign * goal.to - begin;
  switch (goal.shape) {
    case Shape::kHold:
      return begin;
    case Shape::kStep:
      return begin + distance;
    case Shape::kSteps:
      return sign * stepsAt(goal, t);
    case Shape::kRamp:
      return begin + distance * t / duration_s;
    case Shape::kMove:
      return begin + distance * smooth(t / duration_s);
    default:
      return begin + sign * goal.amplitude * swing(goal, duration_s, t);
  }
}

}  // namespace darwinop::experiments
