#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "gap/benchmark/body/poses.hpp"

namespace darwinop::gap {
namespace {

/// Bends a leg: the sole stays level.
void bend(Goals& goals, bool right, double by) {
  const double sign = right ? 1 : -1;
  at(goals, right ? Joint::kLegUpperR : Joint::kLegUpperL) -= sign * by;
  at(goals, right ? Joint::kLegLowerR : Joint::kLegLowerL) += sign * 2 * by;
  at(goals, right ? Joint::kAnkleR : Joint::kAnkleL) += sign * by;
}

/// Shifts the trunk to the left over level soles.
void sway(Goals& goals, double by) {
  for (const Joint joint : {Joint::kPelvR, Joint::kPelvL, Joint::kFootR, Joint::kFootL}) at(goals, joint) += by;
}

/// Swings both arms.
void swing(Goals& goals, double by) {
  at(goals, Joint::kShoulderR) += by, at(goals, Joint::kShoulderL) += by;
}

}  // namespace

Motion squats(Rng& rng) {
  const double hz = rng.between(0.45, 0.65), depth = rng.between(0.1, 0.16), side = rng.between(0.03, 0.06),
               arms = rng.between(0.3, 0.5);
  return [=](double t) {
    RowCommands out{goalsOf(kStanding)};
    const double wave = 1 - std::cos(2 * kPi * hz * t);
    bend(out.goals, true, depth * wave), bend(out.goals, false, depth * wave);
    sway(out.goals, side * std::sin(3 * kPi * hz * t));
    swing(out.goals, arms * std::sin(2 * kPi * hz * t));
    at(out.goals, Joint::kNeck) += 0.5 * std::sin(kPi * hz * t);
    return out;
  };
}

Motion sways(Rng& rng) {
  const double hz = rng.between(0.35, 0.6), side = rng.between(0.05, 0.075), lean = rng.between(0.02, 0.05),
               turn = rng.coin() ? rng.between(0.1, 0.25) : 0, p = rng.coin() ? 32 : 16;
  return [=](double t) {
    RowCommands out{goalsOf(kStanding)};
    out.p_register = p;
    sway(out.goals, side * std::sin(2 * kPi * hz * t));
    bend(out.goals, true, lean * (1 - std::cos(3 * kPi * hz * t)));
    bend(out.goals, false, lean * (1 - std::cos(3 * kPi * hz * t)));
    swing(out.goals, 0.6 * std::sin(2 * kPi * hz * t));
    at(out.goals, Joint::kPelvYR) += turn * std::sin(2 * kPi * hz * t);
    at(out.goals, Joint::kPelvYL) += turn * std::sin(2 * kPi * hz * t);
    return out;
  };
}

Motion walk(Rng& rng) {
  const double hz = rng.between(1.5, 1.75), side = rng.between(0.09, 0.11), lift = rng.between(0.2, 0.28),
               stride = rng.between(-0.02, 0.06), turn = rng.between(-0.03, 0.03);
  return [=](double t) {
    RowCommands out{goalsOf(kStanding)};
    const double phase = 2 * kPi * hz * t, grow = ramp(t, 0.6);
    sway(out.goals, grow * side * std::sin(phase));
    bend(out.goals, true, grow * lift * std::pow(std::max(0.0, std::sin(phase - 0.4)), 2));
    bend(out.goals, false, grow * lift * std::pow(std::max(0.0, -std::sin(phase - 0.4)), 2));
    const double forward = grow * stride * std::cos(phase);
    at(out.goals, Joint::kLegUpperR) += forward, at(out.goals, Joint::kAnkleR) += forward;
    at(out.goals, Joint::kLegUpperL) += forward, at(out.goals, Joint::kAnkleL) += forward;
    at(out.goals, Joint::kPelvYR) += grow * turn * std::cos(phase);
    at(out.goals, Joint::kPelvYL) += grow * turn * std::cos(phase);
    swing(out.goals, 4 * forward);
    return out;
  };
}

Motion bow(double rate, Rng& rng) {
  const double each = rate * rng.between(0.9, 1.1);
  return [each](double t) {
    RowCommands out{goalsOf(kStanding)};
    at(out.goals, Joint::kAnkleR) += each * t, at(out.goals, Joint::kAnkleL) -= each * t;
    return out;
  };
}

Motion stance() {
  return [](double) { return RowCommands{goalsOf(kStanding)}; };
}

}  // namespace darwinop::gap
