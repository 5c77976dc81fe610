// Folders of many raw logs: which are searched, and what happens to those that cannot be used.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder_rig.hpp"
#include "gap/case/write_case.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

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

/// With a pause of the host after half of a second.
std::string withPause(std::string text, double pause_s) {
  for (int i = 199; i >= 40; --i) {
    const auto timestamp = [&](double s) { return "{\"timestamp\": " + std::to_string(s) + ","; };
    text = replaced(text, timestamp(0.0125 * i), timestamp(0.0125 * i + pause_s));
  }
  return text;
}

TEST_F(RawFolderTest, AShortPauseOfTheHostIsPartOfALog) {
  const std::string plain = bamText(zero, zero, "\"kp\": 8, \"motor\": \"mx28\"");
  for (int i = 0; i < 8; ++i) write(folder / ("a" + std::to_string(i) + ".json"), plain);
  write(folder / "paused.json", withPause(plain, 0.4));
  EXPECT_EQ(read().given.logs.size(), 9u);
  write(folder / "paused.json", withPause(plain, 0.6));
  EXPECT_EQ(read().given.logs.size(), 8u);
}

/// With 100 in place of one goal.
std::string withWildGoal(int row) {
  const std::string text = bamText(zero, zero, "\"kp\": 8, \"motor\": \"mx28\"");
  const std::string goal = "\"goal_position\": " + std::to_string(0.5 * std::sin(3 * 0.0125 * row));
  return replaced(text, goal, "\"goal_position\": 100");
}

TEST_F(RawFolderTest, WhatIsWrongIsSaidOfTheEntryOfAJsonFile) {
  for (int i = 0; i < 4; ++i) addLog("a" + std::to_string(i), 8, "0.5");
  write(folder / "wild.json", withWildGoal(150));
  EXPECT_THAT(read().notes, Contains(testing::AllOf(HasSubstr(folder / "wild.json, entries[150]: goal is 100 rad"),
                                                    HasSubstr(messages::kKeysHaveUnits))));
}

TEST_F(RawFolderTest, IfNoLogCanBeUsedTheirNumberAndReasonsAreNamed) {
  write(folder / "a.json", withWildGoal(150));
  write(folder / "b.json", withWildGoal(140));
  write(folder / "c.json", withPause(bamText(zero, zero, "\"kp\": 8, \"motor\": \"mx28\""), 3));
  try {
    (void)read();
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("3 of 3"));
    EXPECT_THAT(refused.what(), HasSubstr("a.json, entries[150]"));
    EXPECT_THAT(refused.what(), HasSubstr("c.json, entries[40]"));
    EXPECT_THAT(refused.what(), HasSubstr("1 more log"));
    EXPECT_THAT(refused.what(), testing::Not(HasSubstr("b.json")));
  }
}

TEST_F(RawFolderTest, IsUsedIfHalfOfItCanBe) {
  for (int i = 0; i < 4; ++i) addLog("a" + std::to_string(i), 8, "0.5");
  for (int i = 0; i < 4; ++i)
    write(folder / ("paused" + std::to_string(i) + ".json"),
          withPause(bamText(zero, zero, "\"kp\": 8, \"motor\": \"mx28\""), 0.6 + i));
  const FolderCase usable = read();
  EXPECT_EQ(usable.given.logs.size(), 4u);
  EXPECT_EQ(std::ranges::count_if(usable.given.logs, &Trajectory::held_out), 1);
  EXPECT_THAT(grouped(usable.notes), Contains(testing::AllOf(HasSubstr(messages::kLeftOut), HasSubstr("3 more logs"))));
  write(folder / "broken.json", "{");
  try {
    (void)read();
    ADD_FAILURE() << "5 of 9 are unusable";
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("5 of 9"));
    EXPECT_THAT(refused.what(), HasSubstr(messages::kUnusableLogs));
    EXPECT_THAT(refused.what(), HasSubstr("broken.json"));
    EXPECT_THAT(refused.what(), HasSubstr("paused0"));
  }
}

TEST_F(RawFolderTest, OfAFewLogsNoneMayBeUnusable) {
  for (const char* const name : {"a", "b"}) addLog(name, 8, "0.5");
  write(folder / "broken.json", "{");
  try {
    (void)read();
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("broken.json"));
  }
  addLog("c", 8, "0.5");
  EXPECT_EQ(read().given.logs.size(), 3u);
}

TEST(Grouped, SaysTheSameOfSeveralLogsOnce) {
  EXPECT_THAT(grouped({"a.json: load is 0", "no clock", "b.json: load is 0", "c.csv: load is 0", "c.csv: late"}),
              ElementsAre("a.json: load is 0 (and 2 more logs)", "no clock", "c.csv: late"));
}

TEST(Grouped, NumbersOfEachLogAreItsOwn) {
  const std::string left_out = messages::kLeftOut;
  const std::vector<std::string> notes{left_out + "x/a.json, line 12: a hole of 0.6 s", "x/b.csv: a hole of 3 s",
                                       left_out + "x/c.json, line 7: a hole of 12.5 s", "2 of 8 logs", "3 of 8 logs"};
  const std::vector<std::string> short_notes = grouped(notes);
  ASSERT_EQ(short_notes.size(), 4u) << "what is left out is not what is odd";
  EXPECT_THAT(short_notes[0], testing::AllOf(testing::StartsWith(notes[0]), HasSubstr("1 more log, each")));
  EXPECT_EQ(short_notes[1], notes[1]);
  EXPECT_EQ(short_notes[3], notes[4]) << "of no log";
}

}  // namespace
}  // namespace darwinop::gap
