// The goal of a joint at any time of a phase.
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

/// Up first, then down, and back: one period.
double triangle(double turns) {
  const double part = turns - std::floor(turns);
  return part < 0.25 ? 4 * part : part < 0.75 ? 2 - 4 * part : 4 * part - 4;
}

/// From hz[0] to hz[1], the frequency rising evenly.
double chirp(const Goal& goal, double duration_s, double t) {
  const double rise = (goal.hz[1] - goal.hz[0]) / duration_s;
  return std::sin(2 * kPi * (goal.hz[0] + rise * t / 2) * t);
}

/// Equal shares that begin at 0, every other one downwards: together never more than 1.
double multisine(const Goal& goal, double t) {
  double sum = 0, side = 1;
  for (const double hz : goal.hz) {
    sum += side * std::sin(2 * kPi * hz * t);
    side = -side;
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
  const double way = sign * goal.to - begin;
  switch (goal.shape) {
    case Shape::kHold:
      return begin;
    case Shape::kStep:
      return begin + way;
    case Shape::kSteps:
      return sign * stepsAt(goal, t);
    case Shape::kRamp:
      return begin + way * t / duration_s;
    case Shape::kMove:
      return begin + way * smooth(t / duration_s);
    default:
      return begin + sign * goal.amplitude * swing(goal, duration_s, t);
  }
}

}  // namespace darwinop::experiments
