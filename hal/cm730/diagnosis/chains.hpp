// Locates breaks in the servo daisy chains. Servos are wired in the order of their ids (1-3-5, 2-4-6, 19-20,
// 7-9-11-13-15-17, 8-10-12-14-16-18), so a bad cable silences the rest of its chain.
#pragma once

#include <optional>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

struct ChainBreak {
  std::optional<Joint> last_answering;  // empty: the whole chain is silent
  std::optional<Joint> first_silent;    // first of the silent rest; empty: the end of the chain answers
  int silent = 0;                       // number of silent servos
};

inline ChainBreak findBreak(const RobotFacts& facts, Chain chain) {
  ChainBreak result;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    if (row(joint).chain != chain || facts.servo[i].absent) continue;
    if (facts.servo[i].found || facts.servo[i].garbled) {
      result = {joint, std::nullopt, 0};
    } else {
      if (!result.first_silent) result.first_silent = joint;
      ++result.silent;
    }
  }
  return result;
}

}  // namespace darwinop::cm730
