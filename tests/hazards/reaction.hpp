// How many cycles pass between a cause and the reaction that the hazard table promises, seen at the servos.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <string>

#include "hazards/rig.hpp"

namespace darwinop::hazards {

/// A robot without a controller: `rig.drive()` starts one.
class ReactionAtStart : public ::testing::Test {
 protected:
  explicit ReactionAtStart(const hil::BoardOptions& options = {}) : rig{options} {}

  /// Counts the cycles from now, the cause, until `done`, and records them for docs/hazards.md. What holds before its
  /// cause does not count.
  void measure(const std::function<bool()>& done, long at_most) { measure(rig, done, at_most); }
  static void measure(HazardRig& rig, const std::function<bool()>& done, long at_most) {
    ASSERT_FALSE(done()) << "holds before its cause";
    record(rig.cyclesUntil(done), at_most);
  }
  static void record(long cycles, long at_most) {
    EXPECT_LE(cycles, at_most);
    RecordProperty("cycles", std::to_string(cycles));
  }

  [[nodiscard]] auto isActive(Fault fault) {
    return [this, fault] { return rig.active(fault); };
  }
  [[nodiscard]] auto isIn(State state) {
    return [this, state] { return rig.state() == state; };
  }
  /// A goal register that is at most 9 ticks from where the joint is: torque on does not make it jump.
  [[nodiscard]] static bool isPlaced(const HazardRig& rig, Joint joint) {
    return std::abs(rig.goal(joint) - rig.position(joint)) <= 9;
  }

  HazardRig rig;
};

/// A controller drives every joint.
class Reaction : public ReactionAtStart {
 protected:
  void SetUp() override { rig.drive(); }
};

}  // namespace darwinop::hazards
