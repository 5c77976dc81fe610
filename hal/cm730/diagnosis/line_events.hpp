// Lost replies by place: noise damages all of them, a loose connector those behind it.
#pragma once

#include <optional>
#include <string>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

struct LooseConnector {
  Joint first{};              // first servo behind it
  std::optional<Joint> from;  // empty: the board
  std::string evidence;
};
/// Replies are lost in the tail of one chain only.
std::optional<LooseConnector> findLooseConnector(const RobotFacts& facts);

/// Reads of servos without a reply.
int lostReplies(const RobotFacts& facts);
/// Lost replies exceed what is normal, by the bytes that were transmitted.
bool isNoisy(const RobotFacts& facts);
std::string noiseText(const RobotFacts& facts);

/// Servos of at least two chains have restarted.
bool acrossChains(const RobotFacts& facts);

}  // namespace darwinop::cm730
