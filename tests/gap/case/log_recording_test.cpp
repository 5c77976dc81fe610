// A recording of the runtime as a log of a case.
#include <gmock/gmock.h>

#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct RecordingRow {
  double t;
  std::string commanded, position, p_gain;
};

std::vector<RecordingRow> recordedRows() {
  std::vector<RecordingRow> rows;
  for (const CsvRow& r : sineRows()) rows.push_back({r.t + 5, std::to_string(r.goal), std::to_string(r.pos), "4"});
  return rows;
}

std::string recordingOf(const std::vector<RecordingRow>& rows) {
  std::string text =
      "# darwinop log, format 1\n# robot: darwin-op\n"
      "time_s,cycle,Neck.asked_speed [rad/s],Neck.asked_p_gain [Kp],Neck.commanded [rad],Neck.position [rad],"
      "Neck.velocity [rad/s],Neck.load,Neck.voltage [V],Neck.temperature [degC]\n";
  int cycle = 0;
  for (const RecordingRow& r : rows)
    text += std::to_string(r.t) + "," + std::to_string(++cycle) + ",12.21," + r.p_gain + "," + r.commanded + "," +
            r.position + ",0.5,0.1,,\n";
  return text + "# end\n";
}

CaseTexts caseOf(const std::vector<RecordingRow>& rows, const std::string& more = "") {
  CaseTexts texts;
  const std::size_t from = texts.json.find("\"logs\"");
  texts.json.replace(
      from, std::string::npos,
      R"("logs": [{"file": "neck.csv", "role": "fit", "joint": "Neck", "payload_kg": 0.3)" + more + "}]}");
  texts.logs["neck.csv"] = recordingOf(rows);
  return texts;
}

TEST(LogRecording, OneJointOfIt) {
  const Case c = caseOf(recordedRows()).read();
  const Trajectory& log = c.logs[0];
  EXPECT_EQ(c.goal_order, GoalOrder::kAfterRead);  // a cycle reads at once: the goal shows in the next row
  EXPECT_EQ(log.p_register, 32);                   // gain 4
  EXPECT_EQ(log.speed_limit_rad_s, 12.21);
  EXPECT_EQ(log.kind, "neck");
  EXPECT_EQ(log.time_s.front(), 0);
  EXPECT_EQ(log.lines.front(), 4u);
  EXPECT_NEAR(log.goal_rad[40], sineRows()[40].goal, 1e-6);
  EXPECT_NEAR(log.position_rad[40], sineRows()[40].pos, 1e-6);
  EXPECT_NEAR(log.load[40], 0.1, 1e-12);
  EXPECT_TRUE(std::isnan(log.volt_v[40]));
}

TEST(LogRecording, ThePGainOfAnOlderRecordingHasTheSameUnitThoughItDoesNotSaySo) {
  CaseTexts older = caseOf(recordedRows());
  std::string& log = older.logs["neck.csv"];
  log.erase(log.find(" [Kp]"), std::string_view{" [Kp]"}.size());
  EXPECT_EQ(older.read().logs[0].p_register, 32);
}

TEST(LogRecording, APGainInAnotherUnitIsRefused) {
  CaseTexts other = caseOf(recordedRows());
  std::string& log = other.logs["neck.csv"];
  log.replace(log.find("[Kp]"), std::string_view{"[Kp]"}.size(), "[%]");
  EXPECT_THAT(other.error(), HasSubstr("column Neck.asked_p_gain is in %, expected Kp"));
}

TEST(LogRecording, TorqueIsOnWhileTheJointIsCommanded) {
  std::vector<RecordingRow> rows = recordedRows();
  for (std::size_t i = 0; i < 5; ++i) rows[i].commanded = "";
  for (std::size_t i = 100; i < 150; ++i) rows[i].commanded = "";
  const Case c = caseOf(rows).read();
  const Trajectory& log = c.logs[0];
  EXPECT_EQ(log.lines.front(), 9u);  // not driven yet: left out
  EXPECT_EQ(log.torque_on[94], 1);
  EXPECT_EQ(log.torque_on[95], 0);
  EXPECT_EQ(log.goal_rad[100], log.goal_rad[94]);  // nothing follows it
  EXPECT_EQ(log.torque_on[145], 1);
}

TEST(LogRecording, FromWhereTheArmHangs) {
  const Case c = caseOf(recordedRows(), R"(, "hangs_at_rad": -0.8)").read();
  EXPECT_NEAR(c.logs[0].position_rad[40], sineRows()[40].pos + 0.8, 1e-6);
  EXPECT_NEAR(c.logs[0].goal_rad[40], sineRows()[40].goal + 0.8, 1e-6);
}

TEST(LogRecording, AGainThatChangesCutsTheLog) {
  std::vector<RecordingRow> rows = recordedRows();
  for (std::size_t i = 150; i < 200; ++i) rows[i].p_gain = "8";
  EXPECT_THAT(caseOf(rows).error(), HasSubstr("my/neck.csv, line 154: the P gain changes here"));
  EXPECT_EQ(caseOf(rows, R"(, "to_s": 7.395)").error(), "");
  EXPECT_THAT(caseOf(rows, R"(, "to_s": 7.395, "kp": 64)").error(), HasSubstr("its P gain is register 32"));
}

TEST(LogRecording, AnswersThatAreMissing) {
  std::vector<RecordingRow> rows = recordedRows();
  for (std::size_t i = 0; i < 20; ++i) rows[10 * i].position = "";
  const Case c = caseOf(rows).read();  // a tenth
  EXPECT_EQ(c.logs[0].rows(), 180u);
  EXPECT_THAT(c.warnings, testing::Contains(HasSubstr("did not answer in 20 of 200 rows, which are left out")));
  rows[5].position = "";
  EXPECT_THAT(caseOf(rows).error(), HasSubstr("did not answer in 21 of 200 rows; check its cable"));
}

TEST(LogRecording, NeedsTheJointAndTheRightGoalOrder) {
  const CaseTexts texts = caseOf(recordedRows());
  EXPECT_THAT(texts.with("\"joint\": \"Neck\", ", "").error(), HasSubstr(messages::kJointNotGiven));
  EXPECT_THAT(texts.with("\"Neck\"", "\"Head\"").error(), HasSubstr("no column \"Head.commanded\""));
  EXPECT_THAT(texts.with("\"logs\"", "\"goal_order\": \"before_read\", \"logs\"").error(),
              AllOf(HasSubstr("`goal_order` is before_read"), HasSubstr("after_read")));
}

}  // namespace
}  // namespace darwinop::gap
