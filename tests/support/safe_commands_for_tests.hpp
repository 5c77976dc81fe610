// Makes SafeCommands without a guard, for tests of what stands behind the guard.
#pragma once

#include "core/safe_commands.hpp"

namespace darwinop {

struct SafeCommandsForTests {
  SafeCommands commands;

  SafeCommandsForTests() : commands{} {}

  SafeCommandsForTests& drive(Joint joint, Rad goal, RadPerSec speed = RadPerSec{12.2},
                              NewtonMeter torque = NewtonMeter{2.5}, double p_gain = 4.0) {
    commands.write_ = SafeCommands::Write::kGoals;
    commands.driven_.set(index(joint));
    commands.skipped_.reset(index(joint));
    commands.goal_[index(joint)] = {goal, speed, torque, p_gain};
    return *this;
  }
  SafeCommandsForTests& driveAll(Rad goal) {
    for (std::size_t i = 0; i < kJoints; ++i) drive(static_cast<Joint>(i), goal);
    return *this;
  }
  SafeCommandsForTests& hold(Joint joint) {
    commands.skipped_.set(index(joint));
    return *this;
  }
  SafeCommandsForTests& torque(Joint joint, bool on) {
    commands.write_ = SafeCommands::Write::kTorque;
    (on ? commands.torque_on_ : commands.torque_off_).set(index(joint));
    return *this;
  }
  SafeCommandsForTests& led(const LedCommand& led) {
    commands.led_ = led;
    return *this;
  }
  SafeCommandsForTests& powerOn() {
    commands.power_on_ = true;
    return *this;
  }
};

}  // namespace darwinop
