// Raw logs that cannot be used: which are left out, and what is reported of them.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "gap/case/case_texts.hpp"
#include "gap/case/grouped_notes.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder_rig.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;

struct UnusableLogs : RawFolderTest {};

TEST_F(UnusableLogs, AFewLogsThatCannotBeUsedAreLeftOutAndNamed) {
  for (int i = 0; i < 12; ++i) addLog("a" + std::to_string(100 + i), 8, "0.5");
  write(folder / "broken.json", "{\"mass\": 0.5,");
  const FolderCase usable = read();
  EXPECT_EQ(usable.given.logs.size(), 12u);
  EXPECT_THAT(usable.notes, Contains(testing::AllOf(HasSubstr(messages::kLeftOut), HasSubstr("broken.json"))));
}

TEST_F(UnusableLogs, ALogThatIsRefusedByItsRowsIsLeftOut) {
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

TEST_F(UnusableLogs, ACsvThatCannotBeUsedIsLeftOutToo) {
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

/// With a pause of the host after half of a second.
std::string withPause(std::string text, double pause_s) {
  for (int i = 199; i >= 40; --i) {
    const auto timestamp = [&](double s) { return "{\"timestamp\": " + std::to_string(s) + ","; };
    text = replaced(text, timestamp(0.0125 * i), timestamp(0.0125 * i + pause_s));
  }
  return text;
}

TEST_F(UnusableLogs, AShortPauseOfTheHostIsPartOfALog) {
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

TEST_F(UnusableLogs, WhatIsWrongIsReportedOfTheEntryOfAJsonFile) {
  for (int i = 0; i < 4; ++i) addLog("a" + std::to_string(i), 8, "0.5");
  write(folder / "wild.json", withWildGoal(150));
  EXPECT_THAT(read().notes, Contains(testing::AllOf(HasSubstr(folder / "wild.json, entries[150]: goal is 100 rad"),
                                                    HasSubstr(messages::kKeysHaveUnits))));
}

TEST_F(UnusableLogs, IfNoLogCanBeUsedTheirNumberAndReasonsAreNamed) {
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

TEST_F(UnusableLogs, IsUsedIfHalfOfItCanBe) {
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

TEST_F(UnusableLogs, OfAFewLogsNoneMayBeUnusable) {
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

}  // namespace
}  // namespace darwinop::gap
