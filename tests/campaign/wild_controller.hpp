// A controller as bad as they come: jumps, NaN, wild gains, limp joints, stalls, new sessions. Seeded.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "core/commands.hpp"

namespace darwinop {

class WildController {
 public:
  explicit WildController(std::uint64_t seed) : random_{seed} { image_.session = 1; }

  const Commands& next() {
    calm_ = false;
    if (stalled_ > 0) {
      --stalled_;
      return image_;
    }
    if (chance(0.0005)) stalled_ = static_cast<int>(between(1, 80));
    if (chance(0.0005)) startSession(chance(0.5));
    if (chance(0.0002)) ++image_.operator_releases;
    if (chance(0.001)) ++image_.operator_resets;
    if (chance(0.01)) ++image_.fault_resets;
    ++image_.sequence;
    for (std::size_t i = 0; i < kJoints; ++i) moveJoint(image_.joint[i], i);
    image_.led.setEye(static_cast<std::uint16_t>(between(0, 65535)));
    ++cycle_;
    return image_;
  }

  /// From now on it behaves: smooth goals, torque on.
  const Commands& calm() {
    if (!calm_) startSession(false);
    calm_ = true;
    ++image_.sequence;
    ++image_.fault_resets;
    for (std::size_t i = 0; i < kJoints; ++i) {
      image_.joint[i] = JointCommand{};
      image_.joint[i].setTorque(true);
      image_.joint[i].setGoal(swing(i));
    }
    ++cycle_;
    return image_;
  }

 private:
  void startSession(bool unattended) {
    ++image_.session;
    image_.unattended = unattended;
  }
  void moveJoint(JointCommand& joint, std::size_t i) {
    joint.setGoal(swing(i));
    if (chance(0.02)) joint.setGoal(Rad{between(-10, 10)});
    if (chance(0.002)) joint.setGoal(Rad{std::numeric_limits<double>::quiet_NaN()});
    if (chance(0.002)) joint.setGoal(Rad{-std::numeric_limits<double>::infinity()});
    if (chance(0.01)) joint.setSpeedLimit(RadPerSec{between(-20, 20)});
    if (chance(0.01)) joint.setTorqueLimit(NewtonMeter{between(-1, 5)});
    if (chance(0.01)) joint.setPGain(between(-5, 50));
    if (chance(0.001)) joint.setTorque(chance(0.7));
  }

  /// Always on the move, each joint differently, so that a stale value differs from a fresh one.
  [[nodiscard]] Rad swing(std::size_t i) const {
    const JointRow& r = kJointTable[i];
    const double middle = (r.low + r.high) / 2.0 - 2048, reach = (r.high - r.low) / 2.0;
    const double phase = 0.02 * static_cast<double>(cycle_) * (1 + 0.1 * static_cast<double>(i));
    return Rad{(middle + 0.8 * reach * std::sin(phase)) * 2 * kPi / 4096};
  }
  bool chance(double p) { return between(0, 1) < p; }
  double between(double low, double high) { return std::uniform_real_distribution{low, high}(random_); }

  std::mt19937_64 random_;
  Commands image_{};
  int stalled_ = 0;
  bool calm_ = false;
  long cycle_ = 0;
};

}  // namespace darwinop
