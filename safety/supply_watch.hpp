// Supply of a robot without a board, from its servos: nothing else shows that it was interrupted, or how high it is.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "core/sensors.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

class SupplyWatch {
 public:
  /// `held_before`: an earlier loop held the joints, so a servo in its power-up state has restarted since.
  explicit SupplyWatch(bool held_before);

  /// Once in each cycle in which the bus answers or is missed.
  void update(const Sensors& seen, Nanos dt) noexcept;

  /// Goals go out to these joints, and with each a speed limit, which need not have been seen. A disturbance that
  /// swallows the first goals and the replies of that cycle looks like an interruption.
  void noteGoals(const std::bitset<kJoints>& written) noexcept;

  /// True in a cycle in which at least half of the servos that had a speed limit are known to have restarted within
  /// kTogether. Fewer are a matter of their joints (JointGuard): a connector of one limb is loose.
  [[nodiscard]] bool interruptedNow() const noexcept { return interrupted_now_; }

  /// Median of the servos' last readings: a single wrong sensor does not count. NaN: none is recent.
  [[nodiscard]] double voltage() const noexcept { return voltage_; }

  // A servo boots in about 0.2 s; those of one supply are back within a second, and are polled at once. Not measured on
  // a robot.
  static constexpr Nanos kTogether{std::chrono::seconds{1}};
  /// Maximum age of a voltage: two polling rounds, in cycles.
  static constexpr std::uint32_t kRecent = 2 * kPollRound;

 private:
  using Joints = std::bitset<kJoints>;

  void notePoll(std::size_t joint, const JointSensors& seen) noexcept;
  void measureVoltage(const Sensors& seen) noexcept;

  Joints limited_;    // have a speed limit or torque, or were sent a goal: a start leaves nothing of these
  Joints missed_;     // missed a reply since the last poll that showed it, or since the first goal
  Joints restarted_;  // within kTogether
  Nanos since_restart_{0};
  bool restarted_now_ = false, polled_now_ = false, interrupted_now_ = false;
  double voltage_ = kUnknown;
};

}  // namespace darwinop::safety
