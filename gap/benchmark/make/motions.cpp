#include "gap/benchmark/make/motions.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "core/conversions.hpp"

namespace darwinop::gap {
namespace {

using Goal = std::function<double(double time_s)>;

/// From 0 to 1 without a jerk at either end.
double eased(double share) {
  const double x = std::clamp(share, 0.0, 1.0);
  return (1 - std::cos(kPi * x)) / 2;
}

// Slow, both ways: what friction and ripple do to it is not hidden by inertia.
Goal slowTriangle(Rng& rng) {
  constexpr double kPeriod = 7;
  const double most = rng.between(0.92, 1.0);
  return [most](double t) { return most * 2 / kPi * std::asin(std::sin(2 * kPi * t / kPeriod)); };
}

Goal steps(Rng& rng) {
  constexpr double kHold = 0.8;
  std::vector<double> levels{-0.9, -0.2833, 0.3333, 0.95};
  rng.shuffle(levels);
  levels.insert(levels.begin(), 0.0);
  return [levels](double t) { return levels[std::min(levels.size() - 1, static_cast<std::size_t>(t / kHold))]; };
}

Goal multisine(Rng& rng) {
  constexpr std::array kHertz{0.35, 0.6, 1.0, 1.55, 2.3};
  struct Sine {
    double rad, hz, phase;
  };
  std::vector<Sine> sines;
  sines.reserve(kHertz.size());
  for (const double hz : kHertz) sines.push_back({1 / (0.5 + hz), hz, rng.between(0, 2 * kPi)});
  const double most = rng.between(0.65, 0.85);
  const auto sum = [sines](double t) {
    double value = 0;
    for (const Sine& sine : sines) value += sine.rad * std::sin(2 * kPi * sine.hz * t + sine.phase);
    return value * eased(t / 0.3);
  };
  double greatest = 0;
  for (double t = 0; t < 4.5; t += kHostPeriod) greatest = std::max(greatest, std::abs(sum(t)));
  return [=](double t) { return most / greatest * sum(t); };
}

// As far as it goes, and back before it is there for long: the motor at its limits.
Goal bang(Rng& rng) {
  constexpr double kMost = 1.15;
  const double half_period_s = rng.between(0.56, 0.65);
  return [=](double t) { return std::fmod(t, 2 * half_period_s) < half_period_s ? kMost : -kMost; };
}

constexpr double kReleasedAt = 1.6;  // s

Goal release(Rng& rng) {
  const double to = rng.sign() * rng.between(1.0, 1.2);
  return [to](double t) { return to * eased(t / 1.25); };
}

Goal chirp(Rng& rng) {
  const double most = rng.between(0.4, 0.46), drift = rng.between(0.15, 0.22);
  return [=](double t) {  // from 0.4 Hz, 0.5 Hz more each second
    return most * std::sin(2 * kPi * (0.4 + 0.25 * t) * t) + drift * std::sin(2 * kPi * 0.21 * t);
  };
}

Goal moves(Rng& rng) {
  constexpr double kEvery = 0.75;
  struct Move {
    double to, time_s;
  };
  std::vector<Move> all(6);
  for (Move& move : all) move = {rng.between(-1.05, 1.05), rng.between(0.3, 0.65)};
  return [all](double t) {
    const auto index = std::min(all.size() - 1, static_cast<std::size_t>(t / kEvery));
    const double from = index == 0 ? 0 : all[index - 1].to;
    return from + (all[index].to - from) * eased((t - static_cast<double>(index) * kEvery) / all[index].time_s);
  };
}

struct MotionRow {
  std::string_view name;
  Goal (*goal)(Rng&);
  std::size_t rows, kept_rows;
};
// In the order of Motion.
constexpr auto kMotions = std::to_array<MotionRow>({
    {"slow_tri", slowTriangle, 438, 438},
    {"steps", steps, 300, 300},
    {"multisine", multisine, 281, 281},
    {"bang", bang, 225, 225},
    {"release", release, 281, 219},
    {"chirp", chirp, 281, 281},
    {"moves", moves, 281, 281},
});

const MotionRow& rowOf(ExcitationMotion motion) {
  return kMotions[static_cast<std::size_t>(motion)];
}

}  // namespace

std::string_view nameOf(ExcitationMotion motion) {
  return rowOf(motion).name;
}

CommandSeries commandsOf(ExcitationMotion motion, bool held_out, Rng& rng) {
  const MotionRow& row = rowOf(motion);
  const Goal goal = row.goal(rng);
  CommandSeries commands;
  for (std::size_t i = 0; i < (held_out ? row.kept_rows : row.rows); ++i) {
    const double time_s = static_cast<double>(i) * kHostPeriod;
    commands.goal_rad.push_back(std::round(goal(time_s) / kRadPerTick) * kRadPerTick);
    commands.torque_on.push_back(motion == ExcitationMotion::kRelease && time_s >= kReleasedAt - kHostPeriod / 2 ? 0
                                                                                                                 : 1);
  }
  return commands;
}

}  // namespace darwinop::gap
