#include "gap/report/body/place_marks.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/joints.hpp"

namespace darwinop::gap {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTrunk = "Body";

std::vector<std::string> placesOf(const Json& at) {
  if (at.is_array()) return at.get<std::vector<std::string>>();
  const auto place = at.get<std::string>();
  if (place == "imu") return {"gyro", "accelerometer"};
  if (place != "all") return {place};
  std::vector<std::string> joints;
  for (const JointRow& joint : kJointTable) joints.emplace_back(joint.name);
  return joints;
}

void markEffect(PlaceMarks& marks, const Json& effect, PlaceState state) {
  const auto id = effect["id"].get<std::string>();
  const std::string label = state == PlaceState::kNamed ? id : id + "?";
  for (const std::string& place : placesOf(effect["at"])) {
    PlaceMark& mark = marks[place];
    mark.state = std::max(mark.state, state);
    const bool is_known = std::ranges::find(mark.labels, label) != mark.labels.end();
    if (effect["at"] != "all" && !is_known) mark.labels.push_back(label);  // twenty labels would hide the robot
  }
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
    mark(row.signal.substr(0, row.signal.find('.')), state);  // "AnkleR.position", "gyro.x"
    if (row.place.kind == Place::Kind::kContact) mark(std::string{kFloorPlace}, state), mark(kTrunk, state);
  }
  const Json& ambiguity = report.answer["ambiguity"];
  for (const Json& group : ambiguity)
    for (const Json& one : group) markEffect(marks, one, PlaceState::kPossible);
  for (const Json& effect : report.answer["effects"])
    markEffect(marks, effect, hasRivals(effect, ambiguity) ? PlaceState::kPossible : PlaceState::kNamed);
  return marks;
}

}  // namespace darwinop::gap
