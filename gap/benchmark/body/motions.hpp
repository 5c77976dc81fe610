// Motions of the ten recordings: what each row writes, as a function of time. Sizes are drawn.
#pragma once

#include <array>
#include <functional>

#include "core/joints.hpp"
#include "core/random.hpp"

namespace darwinop::gap {

using Goals = std::array<double, kJoints>;  // rad, in the order of ids
inline constexpr double kPRegister = 32;

/// What one row writes: goals, P register, limp joints.
struct RowCommands {
  Goals goals;
  double p_register = kPRegister;
  std::array<bool, kJoints> limp{};
};
using Motion = std::function<RowCommands(double time_s)>;

/// Limbs in the air, the trunk clamped. Sines in every joint at once.
Motion sines(Rng& rng);
/// Slow triangles, with less P gain in the second half of `duration_s`.
Motion triangles(double duration_s, Rng& rng);
/// Arms are lifted and fall limp, legs move slowly.
Motion released(Rng& rng);
Motion steps(Rng& rng);

/// On the floor, soles level.
Motion squats(Rng& rng);
Motion sways(Rng& rng);
Motion walk(Rng& rng);
/// Both ankles turn at about this rate, rad/s; positive: forward.
Motion bow(double rate, Rng& rng);
/// Nothing moves.
Motion stance();

}  // namespace darwinop::gap
