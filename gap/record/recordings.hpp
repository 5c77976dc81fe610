// The recordings that a case of the whole robot needs, in the order in which they are made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

struct PlannedRecording {
  std::string file, experiment;  // "upright.csv", "body_sines"
  BodySetup setup = BodySetup::kClamped;
  std::optional<Axes> up;  // clamped: unit vector in the trunk's frame (left, up, forward)
  std::string placing;     // what a person does with the robot before it
  bool held_out = false;
  std::string repeat_of;  // file of an earlier one; empty: none
};

/// The known pose first, twice; then what is new, one thing at a time; a fall only at the end.
std::vector<PlannedRecording> plannedRecordings(bool with_floor);

/// One more for a case: the trunk is clamped with `up`, a unit vector, upwards.
PlannedRecording addedRecording(const std::string& file, const std::string& experiment, const Axes& up);

/// Prior sigmas of a robot about which only data sheets are known; docs/gap/body.md. A simulated robot has its model's
/// numbers, but for what is hidden.
enum class RecordedRobot : std::uint8_t { kSimulated, kPhysical };

/// One recording that was made.
struct MadeRecording {
  PlannedRecording plan;
  double from_s = 0, to_s = 0;  // of the file's clock
  double session_s = 0;         // since the first one began, at from_s
  double battery_v = 0;
};

/// A case.json. `model`: a name, or a file in the case's folder.
std::string bodyCaseJson(const std::string& name, const std::string& model, RecordedRobot robot,
                         const std::vector<MadeRecording>& made);
/// The text of a case.json, with entries for those that it does not have. `file`: what errors call it. Throws BadInput.
std::string withEntries(const std::string& text, const std::string& file, const std::vector<MadeRecording>& made);

}  // namespace darwinop::gap
