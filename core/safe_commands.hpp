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
  /// For a driven joint all four are finite and within range.
  struct JointGoal {
    Rad goal;
    RadPerSec speed_limit;
    NewtonMeter torque_limit;
    double p_gain = 0;
    bool operator==(const JointGoal&) const = default;
  };
  using Mask = std::bitset<kJoints>;

  /// Content of this cycle's SyncWrite.
  enum class Write : std::uint8_t {
    kNothing,  // nothing may be sent (link down, or no session yet)
    kGoals,    // gains, goals, limits of the joints in driven() but not in skipped()
    kTorque,   // torque enable: on for torqueOn(), off for torqueOff(); goals wait for the next cycle
  };

  [[nodiscard]] Write write() const { return write_; }
  [[nodiscard]] const JointGoal& goal(Joint joint) const { return goal_[index(joint)]; }
  [[nodiscard]] const Mask& driven() const { return driven_; }
  /// Driven joints omitted from this cycle's write: they have the goal already, or may have restarted. They keep their
  /// settings.
  [[nodiscard]] const Mask& skipped() const { return skipped_; }
  /// Joints to poll in this cycle: torque is switched on only after their goal registers were read back.
  [[nodiscard]] const Mask& poll() const { return poll_; }
  [[nodiscard]] const Mask& torqueOn() const { return torque_on_; }
  [[nodiscard]] const Mask& torqueOff() const { return torque_off_; }
  [[nodiscard]] const LedCommand& led() const { return led_; }
  /// True: servo power is off, and the board is to switch it on.
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
