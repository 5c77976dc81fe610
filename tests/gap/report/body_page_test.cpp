// Page and report.json of a whole robot.
#include <gmock/gmock.h>

#include "gap/report/body/body_report.hpp"
#include "gap/report/html.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/results.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;

constexpr const char* kPlainRobot = "[model]\nname = robot\n";

/// A report that is made by hand, and what it is of.
struct RobotRig {
  BodyCase given;
  BodyIdentification found;
  BodyReport report;

  explicit RobotRig(Verdict verdict, std::vector<BodyRow> rows = {}, double runtime_s = 1) {
    given.name = "c", given.joints.model = twin::parseModel(kPlainRobot, "m");
    found.verdict = verdict, found.table.rows = std::move(rows), found.runtime_s = runtime_s;
    report = reportOf(given, found, kPlainRobot);
  }
  RobotRig(const RobotRig&) = delete;
  RobotRig& operator=(const RobotRig&) = delete;
};

BodyRow rowOnTheFloor(const std::string& signal, double significance, bool is_open) {
  BodyRow row;
  row.signal = signal, row.place = {.kind = Place::Kind::kContact, .name = "floor"}, row.block = Block::kPlant;
  row.significance = significance, row.open = is_open;
  return row;
}

TEST(BodyPage, SaysOfNoneThatEverythingIsTested) {
  const RobotRig none{Verdict::kNone}, untested{Verdict::kCannotTell};
  EXPECT_THAT(asHtml(none.report), AllOf(HasSubstr(messages::kAgreement), Not(HasSubstr(messages::kNotAllTested))));
  EXPECT_THAT(asHtml(untested.report), AllOf(HasSubstr(messages::kNotAllTested), Not(HasSubstr(messages::kAgreement))));
}

TEST(BodyPage, HasTheSignalsOnTheFloorBeforeAndAfter) {
  RobotRig robot{Verdict::kNamed, {rowOnTheFloor("gyro.x", 9.3, true), rowOnTheFloor("AnkleR.position", 2.5, false)}};
  robot.found.floor.rows_after = {rowOnTheFloor("gyro.x", 1.2, false)};
  const auto cell = [](const char* kind, const std::string& inside) {
    return "<td class=\"" + std::string{kind} + "\">" + inside + "</td>";
  };
  const auto line = [](const std::string& signal, const std::string& cells) {
    return "<tr><th>" + signal + "</th>" + cells + "</tr>";
  };
  EXPECT_THAT(
      asHtml(robot.report),
      AllOf(
          HasSubstr(line("gyro.x", cell("open", html::number(9.3, "9.3")) + cell("closed", html::number(1.2, "1.2")))),
          HasSubstr(line("AnkleR.position", cell("closed", html::number(2.5, "2.5")) + cell("none", "\xe2\x80\x93")))));
}

TEST(BodyPage, HasWhatIsLeftAndWhatWasTriedOnIt) {
  const std::string left = std::string{messages::kOpenSignals} + "gyro.x (plant).";
  RobotRig robot{Verdict::kNamed, {rowOnTheFloor("gyro.x", 9.3, true)}};
  robot.report.answer["effects"].push_back({{"id", "backlash"}, {"at", "all"}, {"params", {{"width", 0.01}}}});
  robot.report.answer["candidates"].push_back(
      {{"id", "link_com"}, {"at", "Body"}, {"params", {{"shift", {0.0, 0.02, 0.0}}}}});
  EXPECT_THAT(asHtml(robot.report),
              AllOf(HasSubstr(messages::kRemainder), HasSubstr(left),
                    HasSubstr(std::string{messages::kTried} + "link_com at Body: shift 0 0.02 0.")));
  const RobotRig unknown{Verdict::kUnknown, {rowOnTheFloor("gyro.x", 9.3, true)}};
  EXPECT_THAT(asHtml(unknown.report), HasSubstr(left));
  const RobotRig explained{Verdict::kNamed, {rowOnTheFloor("gyro.x", 1.2, false)}};
  EXPECT_THAT(asHtml(explained.report),
              AllOf(Not(HasSubstr(messages::kRemainder)), Not(HasSubstr(messages::kOpenSignals))));
}

TEST(BodyPage, NamesTheCommandThatSeparatesWhatIsAmbiguous) {
  RobotRig robot{Verdict::kAmbiguous};
  const Json tilt{{"id", "floor_tilt"}, {"at", "floor"}, {"params", {{"tilt", {0.03, 0.0}}}}};
  robot.report.answer["effects"].push_back(tilt);
  EXPECT_THAT(asHtml(robot.report), Not(HasSubstr(kSeparatedByPlan)));
  robot.report.answer["ambiguity"].push_back(Json::array({tilt, {{"id", "link_com"}, {"at", "Body"}}}));
  EXPECT_THAT(asHtml(robot.report), HasSubstr(kSeparatedByPlan));
}

TEST(BodyPage, HasThePictureAndItsLegend) {
  RobotRig robot{Verdict::kUnknown, {rowOnTheFloor("gyro.x", 9.3, true)}};
  EXPECT_THAT(asHtml(robot.report), AllOf(HasSubstr("<figure><svg"), HasSubstr("<circle class=\"diverges\""),
                                          HasSubstr("<span class=\"diverges\">")));
}

TEST(BodyPage, SaysWhatHeldOutLogsDecide) {
  EXPECT_THAT(asHtml(RobotRig{Verdict::kNone}.report), HasSubstr(messages::kHeldOutUse));
}

TEST(BodyReport, IsTheSameHoweverLongTheSearchTook) {
  const RobotRig fast{Verdict::kNone, {}, 1}, slow{Verdict::kNone, {}, 99};
  EXPECT_EQ(asJson(fast.report).dump(), asJson(slow.report).dump());
  EXPECT_EQ(asJson(fast.report)["format"], kResultsFormat);
  EXPECT_EQ(slow.report.answer["runtime_s"], 99) << "of run --json";
}

}  // namespace
}  // namespace darwinop::gap
