// Recordings of the whole robot that can be made next, and what each demands of a person.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

struct PlannedMotion {
  std::string experiment;  // of darwinop experiment list
  BodySetup setup = BodySetup::kClamped;
  std::optional<Axes> up = {};  // clamped: as in BodyLog
  std::string lies_on = {};     // lying: back or front
  std::string prepare = {};     // "clamp the trunk face down"
  double seconds = 0;           // of robot time: the motion, the way there and back, the preparation

  /// "body_release, face down"
  [[nodiscard]] std::string name() const { return experiment + ", " + where; }
  std::string where = {};  // "face down"
};

/// Motions of `darwinop gap record` in six directions, lying and on the floor; then sways and bows. What cannot be read
/// is left out.
std::vector<PlannedMotion> plannedMotions();

/// `given` with these recordings in place of its own, not measured yet.
BodyCase planned(const BodyCase& given, const std::vector<PlannedMotion>& motions);

}  // namespace darwinop::gap
