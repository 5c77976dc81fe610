// Folders of many raw logs: what they are, which are searched, and what is noted.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "gap/case/case_texts.hpp"
#include "gap/case/data_check.hpp"
#include "gap/case/grouped_notes.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder_rig.hpp"
#include "gap/case/write_case.hpp"

namespace darwinop::gap {
namespace {

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
  for (int i = 0; i < 8; ++i) addLog("b" + std::to_string(100 + i), 16, "0.5");
  const FolderCase chosen = read();
  writeCase(chosen.given, out / "case");
  const Case back = readCase(out / "case");
  ASSERT_EQ(back.others.size(), 28 - kMostFitLogs - kMostHeldOutLogs);
  for (const Trajectory& log : back.others) EXPECT_EQ(log.held_out, log.p_register == 16) << "not for validation";
  EXPECT_EQ(back.others[0].file, chosen.given.others[0].file);
  EXPECT_EQ(back.others[0].rows(), 200u);
  EXPECT_EQ(back.logs.size(), chosen.given.logs.size());
}

TEST_F(RawFolderTest, WhatIsOddAboutEveryLogIsReportedOnce) {
  for (int i = 0; i < 20; ++i)
    addLog("a" + std::to_string(100 + i), 8, "0.5");  // positions between the encoder's steps
  writeCase(read().given, out / "case");
  const Case back = readCase(out / "case");
  for (const std::vector<std::string>& warnings : {back.warnings, checkData(back).warnings}) {
    const auto off_grid =
        std::ranges::count_if(warnings, [](const std::string& one) { return one.find("encoder") != one.npos; });
    EXPECT_EQ(off_grid, 1);
    EXPECT_LE(warnings.size(), 4u);
    EXPECT_THAT(warnings, testing::Contains(HasSubstr("19 more logs")));
  }
}

TEST_F(RawFolderTest, JsonBesideCsvsIsBamIfItHasEntriesOrBamIsGiven) {
  write(folder / "a.csv", csvOf(sineRows()));
  write(folder / "metadata.json", "{\"bench\": 3}");
  RawFolder request{.folder = folder / "",
                    .model = out / "model.ini",
                    .declared = {"kp=32", "payload_kg=0.3", "length_m=0.17", "supply_V=12"},
                    .held_out = {}};
  EXPECT_EQ(readRawFolder(request).given.logs.at(0).file, "a.csv");
  addLog("b", 8, "0.5");
  request.format = RawFormat::kCsv;
  EXPECT_EQ(readRawFolder(request).given.logs.at(0).file, "a.csv");
  request.declared.clear();
  std::filesystem::remove(folder / "metadata.json");
  for (const RawFormat format : {RawFormat::kByFiles, RawFormat::kBam}) {
    request.format = format;
    EXPECT_EQ(readRawFolder(request).given.logs.at(0).p_register, 8);
  }
  std::filesystem::remove(folder / "a.csv");
  request.format = RawFormat::kCsv;
  try {
    (void)readRawFolder(request);
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kNoCsvs));
  }
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

TEST(Grouped, SaysTheSameOfSeveralLogsOnce) {
  EXPECT_THAT(grouped({"a.json: load is 0", "no clock", "b.json: load is 0", "c.csv: load is 0", "c.csv: late"}),
              ElementsAre("a.json: load is 0 (and 2 more logs)", "no clock", "c.csv: late"));
}

TEST(Grouped, NumbersOfEachLogAreItsOwn) {
  const std::string left_out = messages::kLeftOut;
  const std::vector<std::string> notes{left_out + "x/a.json, line 12: a hole of 0.6 s", "x/b.csv: a hole of 3 s",
                                       left_out + "x/c.json, line 7: a hole of -12.5 s", "2 of 8 logs", "3 of 8 logs"};
  const std::vector<std::string> short_notes = grouped(notes);
  ASSERT_EQ(short_notes.size(), 4u) << "what is left out is not what is odd";
  EXPECT_THAT(short_notes[0], testing::AllOf(testing::StartsWith(notes[0]), HasSubstr("1 more log, each")));
  EXPECT_EQ(short_notes[1], notes[1]);
  EXPECT_EQ(short_notes[3], notes[4]) << "of no log";
}

}  // namespace
}  // namespace darwinop::gap
