// Folders of many raw logs: which are searched, and what happens to those that cannot be used.
#include "gap/case/raw_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <utility>

#include "gap/case/bam_text.hpp"
#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/write_case.hpp"
#include "support/replaced.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

struct RawFolderTest : testing::Test {
  const TemporaryFolder folder, out;

  RawFolderTest() { write(out / "model.ini", "[model]\nname = any\n"); }

  static void write(const std::string& path, const std::string& text) { std::ofstream{path} << text; }
  /// A log of that gain and payload.
  void addLog(const std::string& name, int kp, const std::string& mass_kg) const {
    const std::string head = "\"kp\": " + std::to_string(kp) + ", \"motor\": \"mx28\"";
    write(folder / (name + ".json"), replaced(bamText(zero, zero, head), "\"mass\": 0.5", "\"mass\": " + mass_kg));
  }
  [[nodiscard]] FolderCase read(bool all_logs = false) const {
    return readRawFolder(
        {.folder = folder / "", .model = out / "model.ini", .declared = {}, .held_out = {}, .all_logs = all_logs});
  }
};

TEST_F(RawFolderTest, OfManyLogsThoseThatDifferMostAreSearched) {
  for (int i = 0; i < 40; ++i) addLog("a" + std::to_string(100 + i), 8, "0.5");
  for (int i = 0; i < 20; ++i) addLog("b" + std::to_string(100 + i), 16, "0.5");
  addLog("c", 16, "0.9");
  for (int i = 0; i < 12; ++i) addLog("d" + std::to_string(100 + i), 32, "0.5");
  const FolderCase chosen = read();
  std::multiset<std::pair<double, double>> fitted;
  for (const Trajectory& log : chosen.given.logs)
    if (!log.held_out) fitted.emplace(log.p_register, log.payload_kg);
  EXPECT_EQ(fitted.size(), kMostFitLogs);
  EXPECT_EQ(fitted.count({16, 0.9}), 1u) << "the only one of its payload";
  EXPECT_GE(fitted.count({16, 0.5}), 5u) << "half as many logs, not half as many chosen";
  EXPECT_EQ(chosen.given.logs.size(), kMostFitLogs + kMostHeldOutLogs);
  EXPECT_EQ(chosen.given.others.size(), 73 - kMostFitLogs - kMostHeldOutLogs);
  const Case all = read(true).given;
  EXPECT_EQ(all.logs.size(), 73u);
  EXPECT_TRUE(all.others.empty());
}

TEST_F(RawFolderTest, TheOthersStayInTheCase) {
  for (int i = 0; i < 20; ++i) addLog("a" + std::to_string(100 + i), 8, "0.5");
  addLog("b", 16, "0.5");
  const FolderCase chosen = read();
  writeCase(chosen.given, out / "case");
  const Case back = readCase(out / "case");
  ASSERT_EQ(back.others.size(), 20 - kMostFitLogs);
  EXPECT_EQ(back.others[0].file, chosen.given.others[0].file);
  EXPECT_EQ(back.others[0].rows(), 200u);
  EXPECT_EQ(back.logs.size(), chosen.given.logs.size());
}

TEST_F(RawFolderTest, AFewLogsThatCannotBeUsedAreLeftOutAndNamed) {
  for (int i = 0; i < 12; ++i) addLog("a" + std::to_string(100 + i), 8, "0.5");
  write(folder / "broken.json", "{\"mass\": 0.5,");
  const FolderCase usable = read();
  EXPECT_EQ(usable.given.logs.size(), 12u);
  EXPECT_THAT(usable.notes, Contains(testing::AllOf(HasSubstr(messages::kLeftOut), HasSubstr("broken.json"))));
}

TEST_F(RawFolderTest, ALogThatIsRefusedByItsRowsIsLeftOut) {
  for (int i = 0; i < 12; ++i) addLog("a" + std::to_string(100 + i), 8, "0.5");
  addLog("stuck", 8, "0.5");
  std::string text = bamText(zero, zero, "\"kp\": 8, \"motor\": \"mx28\"");
  for (std::size_t at = 0; (at = text.find("\"position\": ", at)) != std::string::npos; at += 12) {
    const std::size_t begin = at + 12, end = text.find(',', begin);
    text.replace(begin, end - begin, "0.3");
  }
  write(folder / "stuck.json", text);
  const FolderCase usable = read();
  EXPECT_EQ(usable.given.logs.size(), 12u);
  EXPECT_THAT(usable.notes, Contains(testing::AllOf(HasSubstr(messages::kLeftOut), HasSubstr("stuck"))));
}

TEST_F(RawFolderTest, ACsvThatCannotBeUsedIsLeftOutToo) {
  for (int i = 0; i < 11; ++i) write(folder / ("a" + std::to_string(100 + i) + ".csv"), csvOf(sineRows()));
  std::vector<CsvRow> stuck = sineRows();
  for (CsvRow& row : stuck) row.pos = 0.3;
  write(folder / "stuck.csv", csvOf(stuck));
  const FolderCase usable = readRawFolder({.folder = folder / "",
                                           .model = out / "model.ini",
                                           .declared = {"kp=32", "payload_kg=0.3", "length_m=0.17", "supply_V=12"},
                                           .held_out = {}});
  EXPECT_EQ(usable.given.logs.size(), 11u);
  EXPECT_THAT(usable.notes, Contains(testing::AllOf(HasSubstr(messages::kLeftOut), HasSubstr("stuck.csv"))));
}

TEST_F(RawFolderTest, AVerticalAxisIsDeclared) {
  write(folder / "a.csv", csvOf(sineRows()));
  const FolderCase usable =
      readRawFolder({.folder = folder / "",
                     .model = out / "model.ini",
                     .declared = {"kp=32", "payload_kg=0.3", "length_m=0.17", "supply_V=12", "axis=vertical"},
                     .held_out = {}});
  EXPECT_EQ(usable.given.pendulum.gravity_m_s2, 0);
  EXPECT_EQ(usable.given.pendulum.length_m, 0.17);
}

TEST_F(RawFolderTest, WhatIsDeclaredOfBamLogsCounts) {
  addLog("a", 8, "0.5");
  const auto declaring = [&](std::vector<std::string> words) {
    return readRawFolder({.folder = folder / "", .model = "", .declared = std::move(words), .held_out = {}}).given;
  };
  const Case plain = declaring({});
  const Case read = declaring({"kt_Nm_A_rel_sigma=0.02", "arm_mass_kg_rel_sigma=0.3", "hangs_at_rad=0.05",
                               "goal_order=after_read", "axis=vertical", "from_s=0.1", "to_s=2.2"});
  const auto sigmaOf = [&](std::string_view number) {
    const auto found = std::ranges::find(read.priors, number, &Prior::number);
    return found == read.priors.end() ? 0 : found->relative_sigma;
  };
  EXPECT_EQ(sigmaOf("kt"), 0.02);
  EXPECT_EQ(sigmaOf("resistance"), 0.15) << "of every bench";
  EXPECT_EQ(sigmaOf("arm_mass"), 0.3);
  EXPECT_EQ(plain.goal_order, GoalOrder::kBeforeRead);
  EXPECT_EQ(read.goal_order, GoalOrder::kAfterRead);
  EXPECT_EQ(read.pendulum.gravity_m_s2, 0);
  EXPECT_EQ(read.logs[0].time_s.front(), 0.1);
  EXPECT_EQ(read.logs[0].time_s.back(), 2.2);
  EXPECT_NEAR(read.logs[0].position_rad[0], plain.logs[0].position_rad[8] - 0.05, 1e-9);
  EXPECT_NEAR(read.logs[0].goal_rad[0], plain.logs[0].goal_rad[8] - 0.05, 1e-9);
  for (const char* const key : {"kp=32", "payload_kg=1", "joint=Elbow", "torque_on=1", "load_raw=load_bit10"}) try {
      (void)declaring({key});
      ADD_FAILURE() << key;
    } catch (const BadInput& refused) {
      EXPECT_THAT(refused.what(), HasSubstr(messages::kOfCsv));
    }
}

TEST_F(RawFolderTest, ASupplyIsDeclaredWhereBamLogsHaveNone) {
  const std::string with = bamText(zero, zero, "\"kp\": 8, \"motor\": \"mx28\"");
  write(folder / "a.json", with);
  const auto declared = [&] {
    return readRawFolder({.folder = folder / "", .model = "", .declared = {"supply_V=11.1"}, .held_out = {}}).given;
  };
  EXPECT_THROW((void)declared(), BadInput) << "the log has one";
  write(folder / "b.json", replaced(with, "\"vin\": 12, ", ""));
  const Case read = declared();
  EXPECT_EQ(supplyOf(read, read.logs[0]), 12);
  EXPECT_EQ(supplyOf(read, read.logs[1]), 11.1);
}

TEST_F(RawFolderTest, AnotherMotorIsDeclaredInFull) {
  write(folder / "a.json", bamText(zero, zero));  // an MX-106
  const auto declaring = [&](const std::vector<std::string>& words) -> std::string {
    try {
      (void)readRawFolder({.folder = folder / "", .model = "", .declared = words, .held_out = {}});
    } catch (const BadInput& refused) {
      return refused.what();
    }
    return "";
  };
  const std::string sheet = "stall_Nm_at_12V=8.4", current = "stall_A_at_12V=5.2", gain = "duty_per_kp_per_rad=0.158";
  EXPECT_EQ(declaring({sheet, current, gain}), "");
  EXPECT_THAT(declaring({"armature_kgm2=0.03"}),
              testing::AllOf(HasSubstr(messages::kNotDeclared), HasSubstr("stall_Nm"), HasSubstr("duty_per_kp")));
  EXPECT_THAT(declaring({sheet, gain}), HasSubstr("stall_A"));
}

TEST_F(RawFolderTest, TheArmatureOfAnotherServoIsNoted) {
  const TemporaryFolder csv;
  write(folder / "a.json", bamText(zero, zero));
  write(csv / "a.csv", csvOf(sineRows()));
  const auto notesFor = [&](const std::string& from, std::vector<std::string> words) {
    for (const char* const one : {"stall_Nm_at_12V=8.4", "stall_A_at_12V=5.2", "duty_per_kp_per_rad=0.158"})
      words.emplace_back(one);
    return readRawFolder({.folder = from, .model = "", .declared = words, .held_out = {}}).notes;
  };
  const auto is_noted = Contains(HasSubstr(messages::kArmatureAssumed));
  EXPECT_THAT(notesFor(folder / "", {}), is_noted);
  EXPECT_THAT(notesFor(folder / "", {"armature_kgm2=0.02"}), testing::Not(is_noted));
  EXPECT_THAT(notesFor(csv / "", {"kp=32", "payload_kg=0.3", "length_m=0.17", "supply_V=12"}), is_noted);
}

TEST_F(RawFolderTest, FalseReadingsStayUntilTheWrittenCaseIsRead) {
  std::vector<CsvRow> rows = sineRows();
  rows[100].pos += 1;
  write(folder / "a.csv", csvOf(rows));
  const FolderCase raw = readRawFolder({.folder = folder / "",
                                        .model = out / "model.ini",
                                        .declared = {"kp=32", "payload_kg=0.3", "length_m=0.17", "supply_V=12"},
                                        .held_out = {}});
  writeCase(raw.given, out / "case");
  const Trajectory back = readCase(out / "case").logs.at(0);
  ASSERT_EQ(back.masked.size(), 1u);
  EXPECT_EQ(back.masked[0].why, messages::kMaskedJump);
}

TEST_F(RawFolderTest, IsRefusedIfMoreThanATenthCannotBeUsed) {
  for (int i = 0; i < 8; ++i) addLog("a" + std::to_string(100 + i), 8, "0.5");
  write(folder / "broken.json", "{");
  try {
    (void)read();
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("broken.json"));
  }
  write(folder / "empty.json", "");
  try {
    (void)read();
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("2 of 10"));
    EXPECT_THAT(refused.what(), HasSubstr(messages::kUnusableLogs));
  }
}

TEST(Grouped, SaysTheSameOfSeveralLogsOnce) {
  EXPECT_THAT(grouped({"a.json: load is 0", "no clock", "b.json: load is 0", "c.csv: load is 0", "c.csv: late"}),
              ElementsAre("a.json: load is 0 (and 2 more logs)", "no clock", "c.csv: late"));
}

}  // namespace
}  // namespace darwinop::gap
