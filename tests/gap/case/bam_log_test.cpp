// Logs of BAM: read, recognized, written, and read again.
#include "gap/case/bam_log.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "gap/case/bam_text.hpp"
#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parse_case.hpp"
#include "gap/case/write_case.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A folder of this log alone.
BamLog parsed(const std::string& text) {
  std::vector<BamLog> logs{parseBamLog(text, "a.json", "a")};
  convertLoads(logs);
  return logs.front();
}

TEST(BamLog, TheHeadIsTheBenchOfTheLog) {
  const Trajectory log = parsed(bamText(zero, zero)).log;
  EXPECT_EQ(log.file, "a.csv");
  EXPECT_EQ(log.kind, "sine");
  EXPECT_EQ(log.p_register, 32);
  EXPECT_EQ(log.payload_kg, 0.5);
  EXPECT_EQ(log.length_m, 0.15);
  EXPECT_EQ(log.arm_mass_kg, 0.1);
  EXPECT_EQ(log.supply_v, 12);
  EXPECT_EQ(log.rows(), 200u);
  EXPECT_EQ(log.volt_v[5], 12.1);
  EXPECT_TRUE(std::isnan(log.temp_c[5]) && std::isnan(log.load[5])) << "absent, or 0 in every row: not measured";
}

TEST(BamLog, TorqueStandsForALoadOfZero) {
  const BamLog read = parsed(bamText(zero, [](int i) { return std::to_string(i < 100 ? 250 : 1'274); }));
  EXPECT_NEAR(read.log.load[0], 0.25, 1e-12);
  EXPECT_NEAR(read.log.load[150], -0.25, 1e-12);
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_THAT(read.notes[0], HasSubstr(messages::kLoadIsZero));
}

TEST(BamLog, TheUnitOfALoadFollowsFromTheWholeColumn) {
  const auto load = [](const char* one, const char* other,
                       const std::string& head = "\"kp\": 32, \"motor\": \"mx106\"") {
    return parsed(bamText([&](int i) { return i < 100 ? one : other; }, zero, head)).log.load[150];
  };
  EXPECT_NEAR(load("0.2", "-0.25"), -0.25, 1e-12);
  EXPECT_NEAR(load("20.5", "-25"), -0.25, 1e-12);
  EXPECT_NEAR(load("200", "-250"), -0.25, 1e-12);
  EXPECT_NEAR(load("200", "65286"), -0.25, 1e-12);
  EXPECT_NEAR(load("200", "65093", "\"kp\": 400, \"motor\": \"xl330\""), -443.0 / 885, 1e-12);
  EXPECT_TRUE(std::isnan(load("200", "99999999")));
}

TEST(BamLog, TheUnitOfALoadIsThatOfTheWholeFolder) {
  const auto loads = [](const std::vector<std::string>& plus) {
    std::vector<BamLog> logs;
    for (const std::string& one : plus)
      logs.push_back(parseBamLog(bamText([&](int i) { return (i < 100 ? "" : "-") + one; }, zero), "a.json", "a"));
    convertLoads(logs);
    std::vector<double> found;
    for (const BamLog& one : logs) found.push_back(one.log.load[0]);
    return found;
  };
  EXPECT_THAT(loads({"1", "250"}), ElementsAre(testing::DoubleNear(0.001, 1e-12), testing::DoubleNear(0.25, 1e-12)));
  EXPECT_THAT(loads({"1"}), ElementsAre(testing::DoubleNear(0.001, 1e-12))) << "a share is a fraction somewhere";
  EXPECT_THAT(loads({"1", "0.25"}), ElementsAre(1, 0.25));
  EXPECT_THAT(loads({"0.25", "250"}), ElementsAre(testing::IsNan(), testing::IsNan())) << "two units";
}

TEST(BamLog, AFewFalseReadingsDecideNoUnitAndAreMasked) {
  const auto loads = [](const char* one, const char* other, const char* false_one) {
    return parsed(bamText([&](int i) { return i == 77 ? false_one : i < 100 ? one : other; }, zero));
  };
  for (const auto& [one, other, false_one] : std::vector<std::array<const char*, 3>>{
           {"250", "1274", "65535"}, {"250", "1274", "3000"}, {"0.25", "-0.25", "1.5"}}) {
    const BamLog read = loads(one, other, false_one);
    EXPECT_NEAR(read.log.load[0], 0.25, 1e-12) << false_one;
    EXPECT_NEAR(read.log.load[150], -0.25, 1e-12) << false_one;
    EXPECT_TRUE(std::isnan(read.log.load[77])) << false_one;
    EXPECT_THAT(read.notes, testing::Contains(HasSubstr(std::string{"1 of 200"} + messages::kLoadsMasked)))
        << false_one;
  }
}

TEST(BamLog, FullDutyEndsAt1023CountsWhereReadingsGoThere) {
  const auto load = [](const char* one, const char* other) {
    return parsed(bamText([&](int i) { return i < 100 ? one : other; }, zero)).log.load;
  };
  EXPECT_NEAR(load("1023", "2047")[0], 1, 1e-12);
  EXPECT_NEAR(load("1023", "2047")[150], -1, 1e-12);
  EXPECT_NEAR(load("1.023", "-0.5115")[0], 1, 1e-12);
  EXPECT_NEAR(load("1.023", "-0.5115")[150], -0.5, 1e-12);
  EXPECT_NEAR(load("102.3", "-51.15")[150], -0.5, 1e-12);
  EXPECT_NEAR(load("312.5", "-250.5")[150], -0.2505, 1e-12) << "resampled counts";
}

TEST(BamLog, ALoadThatPushesAwayFromTheGoalIsMirrored) {
  const BamLog usual = parsed(bamText(zero, zero));
  const auto withGain = [&](double gain) {
    return parsed(bamText(
        [&](int i) {
          const auto row = static_cast<std::size_t>(i);
          return std::to_string(gain * (usual.log.goal_rad[i == 0 ? 0 : row - 1] - usual.log.position_rad[row]));
        },
        zero));
  };
  const BamLog away = withGain(-5), towards = withGain(5);
  EXPECT_EQ(away.log.load, towards.log.load);
  EXPECT_THAT(away.notes, testing::Contains(HasSubstr(messages::kLoadIsMirrored)));
  EXPECT_THAT(towards.notes, testing::Not(testing::Contains(HasSubstr(messages::kLoadIsMirrored))));
}

/// The text of a log with one of its words replaced, in the first entry that has it.
std::string changed(std::string text, const std::string& from, const std::string& to, bool everywhere = false) {
  for (std::size_t at = text.find(from); at != text.npos; at = everywhere ? text.find(from, at + to.size()) : text.npos)
    text.replace(at, from.size(), to);
  return text;
}

TEST(BamLog, LoneRowsThatCannotBeUsedAreLeftOut) {
  const std::string text = bamText(zero, zero);
  const auto read = [](const std::string& changed_text) { return parsed(changed_text).log; };
  EXPECT_EQ(read(changed(text, "\"timestamp\": 1.000000", "\"timestamp\": 1000")).rows(), 199u) << "a lone false time";
  EXPECT_EQ(read(changed(text, "\"timestamp\": 1.000000", "\"timestamp\": null")).rows(), 199u);
  const std::string with_nan = changed(text, "\"goal_position\": 0.018746", "\"goal_position\": NaN");
  ASSERT_TRUE(with_nan != text);
  EXPECT_EQ(read(with_nan).rows(), 199u);
  const Trajectory limp = read(changed(changed(text, "\"torque_enable\": true", "\"torque_enable\": false", true),
                                       "\"goal_position\": 0.018746", "\"goal_position\": null"));
  ASSERT_EQ(limp.rows(), 200u) << "a limp row needs no goal";
  for (std::size_t row = 1; row < limp.rows(); ++row) ASSERT_FALSE(std::isnan(limp.goal_rad[row]));
  EXPECT_TRUE(std::isnan(read(changed(text, "\"input_volts\": 12.1", "\"input_volts\": -Infinity")).volt_v[0]));
}

TEST(BamLog, AClockThatWasSetMakesTwoLogs) {
  std::string text = bamText(zero, zero);
  for (int i = 120; i < 200; ++i)
    text = changed(text, "\"timestamp\": " + std::to_string(0.0125 * i),
                   "\"timestamp\": " + std::to_string(0.0125 * i - 0.5));
  try {
    (void)parseBamLog(text, "a.json", "a");
    FAIL() << "spliced";
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kClockWasSet));
  }
}

TEST(BamLog, AColumnInAnotherUnitIsLeftOutAndTheLogStays) {
  const std::string text = bamText(zero, zero);
  const auto left_out = [&](const std::string& from, const std::string& to) {
    const BamLog read = parsed(changed(text, from, to, true));
    EXPECT_EQ(read.log.rows(), 200u) << to;
    EXPECT_THAT(read.notes, testing::Contains(HasSubstr(messages::kColumnLeftOut))) << to;
    return read.log;
  };
  EXPECT_TRUE(std::isnan(left_out("\"speed\": ", "\"speed\": 12.5, \"was\": ").speed_rad_s[9])) << "rpm";
  EXPECT_TRUE(std::isnan(left_out("\"speed\": ", "\"speed\": 1500, \"was\": ").speed_rad_s[9])) << "counts";
  EXPECT_TRUE(std::isnan(left_out("\"speed\": ", "\"speed\": 0, \"was\": ").speed_rad_s[9])) << "not read";
  EXPECT_TRUE(std::isnan(left_out("\"input_volts\": 12.1", "\"input_volts\": 0").volt_v[9]));
  EXPECT_TRUE(std::isnan(left_out("\"input_volts\": 12.1", "\"input_volts\": 121").volt_v[9]));
}

TEST(BamLog, OnlyTwosComplementIsTheDutyOfAnXSeries) {
  const auto load = [](int i) { return std::to_string(i < 100 ? 250 : 1'274); };
  const BamLog read = parsed(bamText(load, zero, "\"kp\": 400, \"motor\": \"xl330\""));
  EXPECT_NEAR(read.log.load[150], -0.25, 1e-12);
}

TEST(BamLog, WhatIsAssumedIsNoted) {
  const auto notes = [](std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what))
      text.replace(at, what.size(), by);
    return parsed(text).notes;
  };
  const std::string text = bamText(zero, zero);
  EXPECT_THAT(parsed(text).notes, ElementsAre(HasSubstr(messages::kLoadIsZero)));
  EXPECT_THAT(notes(text, "\"load\": 0, \"torque\": 0, ", ""), ElementsAre());
  EXPECT_THAT(notes(text, "\"torque_enable\": true, ", ""),
              ElementsAre(HasSubstr("200" + std::string{messages::kNoTorqueEnable}), HasSubstr(messages::kLoadIsZero)));
}

TEST(BamLog, IsRefusedWithoutRowsOrCommands) {
  const auto error = [](const std::string& text) {
    try {
      (void)parseBamLog(text, "a.json", "a");
    } catch (const BadInput& refused) {
      return std::string{refused.what()};
    }
    return std::string{};
  };
  EXPECT_THAT(error("[]"), HasSubstr(messages::kNotJsonObject));
  EXPECT_THAT(error(R"({"kp": 1, "mass": 1, "length": 0.1, "entries": []})"), HasSubstr(messages::kMissing));
  EXPECT_THAT(error(R"({"kp": 1, "mass": 1, "length": 0.1, "entries": [{"timestamp": 1}]})"),
              HasSubstr(messages::kNotBamRow));
  EXPECT_THAT(error(R"({"kp": 1, "mass": 1, "length": 0.1, "entries": [3]})"), HasSubstr(messages::kNotBamRow));
}

TEST(BamLog, ACommandWrittenAfterARowsReadBelongsToTheNextRow) {
  const Case c = CaseTexts{}.read();
  const Trajectory& log = c.logs[0];
  const Trajectory back = parseBamLog(asBamJson(c, log, "mx28"), "a.json", "fit_1").log;
  EXPECT_EQ(back.goal_rad[0], log.goal_rad[0]);
  for (std::size_t row = 1; row < log.rows(); ++row) {
    ASSERT_EQ(back.goal_rad[row], log.goal_rad[row - 1]);
    ASSERT_EQ(back.torque_on[row], log.torque_on[row - 1]);
  }
}

TEST(BamLog, WhatIsWrittenIsReadBack) {
  Case c = CaseTexts{}.read();
  c.goal_order = GoalOrder::kBeforeRead;
  const Trajectory& log = c.logs[0];
  std::vector<BamLog> logs{parseBamLog(asBamJson(c, log, "mx28"), "a.json", "fit_1")};
  convertLoads(logs);
  const Trajectory& back = logs.front().log;
  EXPECT_EQ(back.file, log.file);
  EXPECT_EQ(back.p_register, log.p_register);
  EXPECT_EQ(back.length_m, armOf(c, log).length_m);
  EXPECT_EQ(back.supply_v, supplyOf(c, log));
  EXPECT_EQ(back.time_s, log.time_s);
  EXPECT_EQ(back.goal_rad, log.goal_rad);
  EXPECT_EQ(back.position_rad, log.position_rad);
  EXPECT_EQ(back.load, log.load);
  EXPECT_EQ(back.volt_v, log.volt_v);
}

}  // namespace
}  // namespace darwinop::gap
