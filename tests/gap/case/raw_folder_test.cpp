// Folders of many raw logs: which are searched, and what happens to those that cannot be used.
#include <gmock/gmock.h>

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
