// A robot with one effect of the mechanics, and what the search finds in it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "gap/body/moving_robot.hpp"
#include "gap/identify/body/mechanics_entry.hpp"

namespace darwinop::gap {

inline const MechanicalEffect& effectCalled(std::string_view id) {
  return *std::ranges::find(mechanicalEffects(), id, &MechanicalEffect::id);
}

inline BodyHypothesis shippedWith(std::string_view id, const std::vector<Joint>& joints,
                                  const std::vector<double>& values) {
  BodyHypothesis robot = shippedRobot();
  for (const Joint joint : joints) effectCalled(id).apply(robot, joint, values);
  return robot;
}

inline std::vector<Joint> allJoints() {
  std::vector<Joint> all;
  for (std::size_t joint = 0; joint < kJoints; ++joint) all.push_back(static_cast<Joint>(joint));
  return all;
}

inline MechanicsSelection selectionFor(const BodyCase& given) {
  ClampedRobot robot{given};
  return identifyMechanics(robot, localize(given, RestingImu{given.joints.model}, robot));
}

inline std::vector<std::string> namesOf(const std::vector<FoundMechanics>& found) {
  std::vector<std::string> out;
  for (const FoundMechanics& one : found) {
    out.emplace_back(one.placed.effect->id);
    for (const Joint joint : one.placed.joints) out.back() += " " + std::string{row(joint).name};
  }
  return out;
}

}  // namespace darwinop::gap
