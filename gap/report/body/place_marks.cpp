#include "gap/report/body/place_marks.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/joints.hpp"

namespace darwinop::gap {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTrunk = "Body";

/// "AnkleR" of "AnkleR.position", "gyro" of "gyro.x".
std::string placeOf(const std::string& signal) {
  return signal.substr(0, signal.find('.'));
}

std::vector<std::string> placesOf(const Json& at) {
  if (at.is_array()) return at.get<std::vector<std::string>>();
  const auto place = at.get<std::string>();
  if (place == "imu") return {"gyro", "accelerometer"};
  if (place != "all") return {place};
  std::vector<std::string> joints;
  for (const JointRow& joint : kJointTable) joints.emplace_back(joint.name);
  return joints;
}

void addLabel(PlaceMark& mark, const std::string& label) {
  if (std::ranges::find(mark.labels, label) == mark.labels.end()) mark.labels.push_back(label);
}

void markEffect(PlaceMarks& marks, const Json& effect, PlaceState state) {
  const auto id = effect["id"].get<std::string>();
  const std::string label = state == PlaceState::kNamed ? id : id + "?";
  for (const std::string& place : placesOf(effect["at"])) {
    PlaceMark& mark = marks[place];
    mark.state = std::max(mark.state, state);
    if (effect["at"] != "all") addLabel(mark, label);
  }
  if (effect["at"] == "all") addLabel(marks[kAllJoints], label);  // twenty labels would hide the robot
}

bool isSame(const Json& a, const Json& b) {
  return a["id"] == b["id"] && a["at"] == b["at"];
}

/// Whether other names stand beside it.
bool hasRivals(const Json& effect, const Json& ambiguity) {
  return std::ranges::any_of(ambiguity, [&](const Json& group) {
    return std::ranges::any_of(group, [&](const Json& one) { return isSame(one, effect); });
  });
}

}  // namespace

PlaceMarks marksOf(const BodyReport& report) {
  PlaceMarks marks;
  const auto mark = [&](const std::string& place, PlaceState state) {
    PlaceState& now = marks[place].state;
    now = std::max(now, state);
  };
  const std::vector<OpenSignal> open = openSignals(report);
  for (const BodyRow& row : report.found->table.rows) {
    const bool diverges = row.open && std::ranges::find(open, row.signal, &OpenSignal::signal) != open.end();
    const PlaceState state = diverges ? PlaceState::kDiverges : PlaceState::kAgrees;
    mark(placeOf(row.signal), state);
    if (row.place.kind == Place::Kind::kContact) mark(std::string{kFloorPlace}, state), mark(kTrunk, state);
  }
  const Json& ambiguity = report.answer["ambiguity"];
  for (const Json& group : ambiguity)
    for (const Json& one : group) markEffect(marks, one, PlaceState::kPossible);
  for (const Json& effect : report.answer["effects"])
    markEffect(marks, effect, hasRivals(effect, ambiguity) ? PlaceState::kPossible : PlaceState::kNamed);
  // The colour of a name would hide what it leaves.
  for (const OpenSignal& one : open)
    if (PlaceMark& at = marks[placeOf(one.signal)]; at.state > PlaceState::kDiverges) addLabel(at, kNotAllExplained);
  return marks;
}

}  // namespace darwinop::gap
