#include <cmath>

#include "core/units.hpp"
#include "gap/benchmark/body/poses.hpp"

namespace darwinop::gap {

Motion sines(Rng& rng) {
  struct Wave {
    double amplitude, rate, phase;
  };
  std::array<std::array<Wave, 4>, kJoints> waves{};
  for (auto& joint : waves)
    for (Wave& wave : joint) {
      const double hz = rng.between(0.35, 2.2);
      wave = {rng.between(0.05, 0.11) / std::sqrt(hz), 2 * kPi * hz, rng.between(0, 2 * kPi)};
    }
  return [waves](double t) {
    RowCommands out{goalsOf(kHanging)};
    for (std::size_t i = 0; i < kJoints; ++i)
      for (const Wave& wave : waves[i])
        out.goals[i] += ramp(t, 0.3) * wave.amplitude * std::sin(wave.rate * t + wave.phase);
    return out;
  };
}

Motion triangles(double duration_s, Rng& rng) {
  Goals slope{}, phase{};
  for (std::size_t i = 0; i < kJoints; ++i) slope[i] = rng.between(0.25, 0.45), phase[i] = rng.between(0, 4);
  const double p = rng.coin() ? 16 : 8;
  return [=](double t) {
    RowCommands out{goalsOf(kHanging)};
    for (std::size_t i = 0; i < kJoints; ++i)
      out.goals[i] +=
          slope[i] * (std::abs(std::remainder(t + phase[i], 4)) - std::abs(std::remainder(phase[i], 4))) / 2;
    out.p_register = 2 * t > duration_s ? p : kPRegister;
    return out;
  };
}

Motion released(Rng& rng) {
  const double lift = rng.between(0.7, 1.2), hz = rng.between(0.3, 0.5);
  return [=](double t) {
    RowCommands out{goalsOf(kHanging)};
    const double up = lift * ramp(t, 0.7);
    at(out.goals, Joint::kShoulderR) -= up, at(out.goals, Joint::kShoulderL) += up;
    at(out.goals, Joint::kArmLowerR) -= up / 3, at(out.goals, Joint::kArmLowerL) += up / 3;
    for (std::size_t i = 6; i < kJoints; ++i)
      out.goals[i] += 0.15 * (std::cos(2 * kPi * hz * t + static_cast<double>(i)) - std::cos(static_cast<double>(i)));
    for (std::size_t i = 0; i < 6; ++i) out.limp[i] = t > 1.0 && t < 2.3;
    return out;
  };
}

Motion steps(Rng& rng) {
  Goals size{}, period{};
  for (std::size_t i = 0; i < kJoints; ++i)
    size[i] = rng.between(0.1, 0.25) * rng.sign(), period[i] = rng.between(0.4, 0.7);
  return [=](double t) {
    RowCommands out{goalsOf(kHanging)};
    for (std::size_t i = 0; i < kJoints; ++i)
      if (static_cast<int>(t / period[i]) % 2 == 1) out.goals[i] += size[i];
    return out;
  };
}

}  // namespace darwinop::gap
