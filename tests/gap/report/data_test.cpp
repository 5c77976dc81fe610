// Which recordings a report is of, and the files of its folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "gap/report/data_hash.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/read_results.hpp"
#include "gap/report/report_folder.hpp"
#include "gap/report/report_rig.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(DataHash, IsThatOfSha256sum) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(DataHash, ChangesWithTheDataAndNotWithTheFolder) {
  Case given = twoLogs();
  for (Trajectory& log : given.logs) log.file = log.held_out ? "score 1.csv" : "fit_1.csv";
  EXPECT_EQ(dataHash(given), "") << "it lies in no folder";
  given.folder = testing::TempDir() + "/darwinop_data_hash";
  std::filesystem::create_directories(given.folder);
  for (const char* file : {"case.json", "fit_1.csv", "score 1.csv"})
    std::ofstream{std::filesystem::path{given.folder} / file} << file;
  EXPECT_EQ(dataHash(given), sha256("case.jsonfit_1.csvscore 1.csv"));
  EXPECT_EQ(hashCommand(given), "cat case.json fit_1.csv 'score 1.csv' | sha256sum");
}

TEST(WriteReport, SaysWhatToDoWhenItCannot) {
  const ReportRig rig;
  const std::string file = testing::TempDir() + "/darwinop_no_folder";
  std::ofstream{file} << "a file";
  try {
    writeReport(rig.report, file + "/report");
    FAIL() << "a file is no folder";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(file + "/report"), HasSubstr("--report")));
  }
}

TEST(WriteReport, KeepsTheReportOfAnotherCaseOfThisName) {
  const std::string folder = testing::TempDir() + "/darwinop_two_reports", file = folder + "/report.json";
  std::filesystem::remove_all(folder);
  writeReportFolder(folder, {{"report.json", "of site A"}});
  writeReportFolder(folder, {{"report.json", "of site A"}});
  EXPECT_FALSE(std::filesystem::exists(file + ".before")) << "the same again";
  writeReportFolder(folder, {{"report.json", "of site B"}});
  EXPECT_EQ(readTextFile(file), "of site B");
  EXPECT_EQ(readTextFile(file + ".before"), "of site A");
}

TEST(AddFromReport, OfOtherRecordingsIsReported) {
  const std::string report = R"({"case": "c", "data_sha256": "1234"})";
  EXPECT_EQ(otherDataWarning(report, "report.json", "1234"), "");
  EXPECT_EQ(otherDataWarning(report, "report.json", "5678"), std::string{"report.json"} + messages::kOtherData);
  EXPECT_EQ(otherDataWarning(R"({"case": "c"})", "report.json", "5678"), "") << "an older report has no hash";
  EXPECT_EQ(otherDataWarning(R"([{"case": "c"}])", "results.json", "5678"), "") << "that of a suite neither";
}

}  // namespace
}  // namespace darwinop::gap
