// Commands that have passed the safety layer. The bus accepts nothing else, and only safety::Guard can make one:
// bypassing it does not compile.
#pragma once

#include <array>
#include <bitset>

#include "core/commands.hpp"
#include "core/joints.hpp"
#include "core/units.hpp"

namespace darwinop {

namespace safety {
class Guard;
}

class SafeCommands {
 public:
  /// All four are set for a joint that is driven, finite and within range.
  struct JointGoal {
    Rad goal;
    RadPerSec speed_limit;
    NewtonMeter torque_limit;
    double p_gain = 0;
    bool operator==(const JointGoal&) const = default;
  };
  using Mask = std::bitset<kJoints>;

  /// What this cycle's SyncWrite carries.
  enum class Write : std::uint8_t {
    kNothing,  // nothing may be sent (link down, nobody drives yet)
    kGoals,    // gains, goals, limits of the joints in driven() without skipped()
    kTorque,   // torque enable: on for torqueOn(), off for torqueOff(); goals wait for the next cycle
  };

  [[nodiscard]] Write write() const { return write_; }
  [[nodiscard]] const JointGoal& goal(Joint joint) const { return goal_[index(joint)]; }
  [[nodiscard]] const Mask& driven() const { return driven_; }
  /// Driven joints that this cycle's write leaves out: they have the goal above already, or it is not certain that
  /// they still hold it. They keep their settings.
  [[nodiscard]] const Mask& skipped() const { return skipped_; }
  /// Joints whose servos are to be polled in this cycle: torque waits for their goal registers.
  [[nodiscard]] const Mask& poll() const { return poll_; }
  [[nodiscard]] const Mask& torqueOn() const { return torque_on_; }
  [[nodiscard]] const Mask& torqueOff() const { return torque_off_; }
  [[nodiscard]] const LedCommand& led() const { return led_; }
  /// True: the board reports that servo power is off and shall switch it on.
  [[nodiscard]] bool powerOn() const { return power_on_; }

 private:
  friend class safety::Guard;
  friend struct SafeCommandsForTests;  // defined by tests that need a bus without a guard
  SafeCommands() = default;

  Write write_ = Write::kNothing;
  std::array<JointGoal, kJoints> goal_{};
  Mask driven_, skipped_, poll_, torque_on_, torque_off_;
  LedCommand led_{};
  bool power_on_ = false;
};

}  // namespace darwinop
