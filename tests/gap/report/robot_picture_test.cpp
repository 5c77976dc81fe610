// The picture of a robot, and what it shows at each place.
#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "core/joints.hpp"
#include "gap/report/body/place_marks.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Json = nlohmann::ordered_json;

const twin::Model& darwin() {
  static const twin::Model kDarwin = twin::readModel(twin::findModel("darwin-op"));
  return kDarwin;
}

/// Classes of the shapes of a place, each once.
std::string statesOf(const std::string& place, const std::string& picture) {
  std::set<std::string> states;
  const std::regex shape{"<(polygon|circle|rect) class=\"([a-z]+)\"[^>]*><title>" + place + ":"};
  for (std::sregex_iterator one{picture.begin(), picture.end(), shape}, end; one != end; ++one)
    states.insert((*one)[2]);
  std::string out;
  for (const std::string& state : states) out += (out.empty() ? "" : " ") + state;
  return out;
}

TEST(RobotPicture, ShowsEachLinkInItsState) {
  const std::string picture =
      robotPicture(darwin(), {{"AnkleR", {PlaceState::kDiverges}}, {"Neck", {PlaceState::kNamed, {"viscous"}}}});
  for (const JointRow& joint : kJointTable) {
    const std::string name{joint.name};
    EXPECT_EQ(statesOf(name, picture), name == "AnkleR" ? "diverges" : name == "Neck" ? "named" : "untested") << name;
  }
  EXPECT_EQ(statesOf("Body", picture), "untested");
}

TEST(RobotPicture, LabelsANamedPlaceBesideTheRobot) {
  const std::string picture = robotPicture(darwin(), {{"FootL", {PlaceState::kNamed, {"coulomb"}}},
                                                      {"ArmUpperR", {PlaceState::kPossible, {"link_mass?"}}},
                                                      {"Head", {PlaceState::kAgrees}}});
  // The robot looks at us: its left is on our right.
  EXPECT_THAT(picture, HasSubstr("text-anchor=\"start\">FootL: coulomb</text>"));
  EXPECT_THAT(picture, HasSubstr("text-anchor=\"end\">ArmUpperR: link_mass?</text>"));
  EXPECT_THAT(picture, Not(ContainsRegex("<text[^>]*>Head")));
}

TEST(RobotPicture, ShowsSensorsAndFloor) {
  const std::string picture = robotPicture(
      darwin(), {{"gyro", {PlaceState::kNamed, {"gyro_bias"}}}, {std::string{kFloorPlace}, {PlaceState::kAgrees}}});
  EXPECT_EQ(statesOf("gyro", picture), "named");
  EXPECT_EQ(statesOf("battery", picture), "") << "not marked";
  EXPECT_EQ(statesOf("battery", robotPicture(darwin(), {{"battery", {PlaceState::kPossible}}})), "possible");
  EXPECT_EQ(statesOf("floor", picture), "agrees");
}

/// A report with these rows, of which the open ones are not explained.
struct MarkedReport {
  BodyCase given;
  BodyIdentification found;
  BodyReport report;

  explicit MarkedReport(const std::vector<std::pair<std::string, bool>>& signals,
                        Place::Kind kind = Place::Kind::kJoint) {
    report.given = &given, report.found = &found;
    report.answer = {{"effects", Json::array()},
                     {"ambiguity", Json::array()},
                     {"where", Json::array()},
                     {"remainder", {{"signals", Json::array()}}}};
    for (const auto& [signal, is_open] : signals) {
      BodyRow row;
      row.signal = signal, row.place.kind = kind, row.open = is_open;
      found.table.rows.push_back(row);
      if (!is_open) continue;
      report.answer["where"].push_back({{"signal", signal}, {"block", "plant"}});
      report.answer["remainder"]["signals"].push_back(signal);
    }
  }
  MarkedReport(const MarkedReport&) = delete;
  MarkedReport& operator=(const MarkedReport&) = delete;
};

Json effectAt(const char* id, const Json& at) {
  return {{"id", id}, {"at", at}};
}

TEST(PlaceMarks, AnOpenSignalThatIsExplainedDoesNotDiverge) {
  MarkedReport robot{{{"Neck.position", true}, {"Head.position", true}, {"Head.load", false}, {"AnkleR.load", false}}};
  robot.report.answer["remainder"]["signals"] = {"Head.position"};
  const PlaceMarks marks = marksOf(robot.report);
  EXPECT_EQ(marks.at("Neck").state, PlaceState::kAgrees);
  EXPECT_EQ(marks.at("Head").state, PlaceState::kDiverges);
  EXPECT_EQ(marks.at("AnkleR").state, PlaceState::kAgrees);
  EXPECT_FALSE(marks.contains("AnkleL"));
}

TEST(PlaceMarks, ANameIsMoreThanWhatIsLeftThere) {
  MarkedReport robot{{{"Neck.position", true}}};
  robot.report.answer["effects"] = {effectAt("viscous", "Neck"), effectAt("backlash", {"Neck", "Head"})};
  const PlaceMarks marks = marksOf(robot.report);
  EXPECT_EQ(marks.at("Neck").state, PlaceState::kNamed);
  EXPECT_THAT(marks.at("Neck").labels, ElementsAre("viscous", "backlash", kNotAllExplained));
  EXPECT_THAT(marks.at("Head").labels, ElementsAre("backlash"));
}

TEST(PlaceMarks, RivalsArePossible) {
  MarkedReport robot{{}};
  const Json tilt = effectAt("floor_tilt", "floor");
  robot.report.answer["effects"] = {tilt, effectAt("imu_mounting", "imu")};
  robot.report.answer["ambiguity"].push_back(Json::array({tilt, effectAt("link_com", "Body")}));
  const PlaceMarks marks = marksOf(robot.report);
  EXPECT_EQ(marks.at("floor").state, PlaceState::kPossible);
  EXPECT_EQ(marks.at("Body").state, PlaceState::kPossible);
  EXPECT_THAT(marks.at("Body").labels, ElementsAre("link_com?"));
  EXPECT_EQ(marks.at("gyro").state, PlaceState::kNamed);
  EXPECT_THAT(marks.at("accelerometer").labels, ElementsAre("imu_mounting"));
}

TEST(PlaceMarks, AnEffectOfAllJointsHasOneLabel) {
  MarkedReport robot{{}};
  robot.report.answer["effects"].push_back(effectAt("coulomb", "all"));
  const PlaceMarks marks = marksOf(robot.report);
  EXPECT_THAT(marks.at(kAllJoints).labels, ElementsAre("coulomb"));
  EXPECT_EQ(marks.at("AnkleR").state, PlaceState::kNamed);
  EXPECT_THAT(marks.at("AnkleR").labels, IsEmpty());
}

TEST(PlaceMarks, WhatDivergesOnTheFloorMayBeOfTrunkAndFloor) {
  MarkedReport robot{{{"AnkleR.position", true}}, Place::Kind::kContact};
  const PlaceMarks marks = marksOf(robot.report);
  for (const char* const place : {"AnkleR", "floor", "Body"}) EXPECT_EQ(marks.at(place).state, PlaceState::kDiverges);
}

}  // namespace
}  // namespace darwinop::gap
