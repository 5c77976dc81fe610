// Arguments of `darwinop gap`: options count before and behind the name of a command.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "gap/case/messages.hpp"
#include "gap/case/raw_folder.hpp"
#include "gap/case/write_case.hpp"
#include "gap/small_case.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"
#include "twin/model/messages.hpp"

namespace darwinop::gap {
namespace {

const std::string kGap = DARWINOP_GAP, kExample = DARWINOP_GAP_EXAMPLE;

TEST(GapOptions, CountBeforeAndBehindTheCommand) {
  const std::string behind = shell(kGap + " locate " + kExample + " --json --threads 1").said;
  ASSERT_THAT(behind, testing::StartsWith("{"));
  EXPECT_EQ(shell(kGap + " --json --threads 1 locate " + kExample).said, behind);
}

TEST(GapOptions, CountBeforeACommandOfTwoWords) {
  const Outcome behind = shell(kGap + " benchmark score --json none.json none.json");
  const Outcome before = shell(kGap + " --json --threads 1 benchmark score none.json none.json");
  EXPECT_EQ(before.said, behind.said);
  EXPECT_EQ(before.status, 2);
}

TEST(GapOptions, ThatAreUnknownAreRefusedBeforeTheCommandToo) {
  EXPECT_EQ(shell(kGap + " --jsn locate " + kExample).status, 2);
  EXPECT_EQ(shell(kGap + " --json").status, 2) << "no command";
}

TEST(GapOptions, ACaseIsAlsoNamedByItsCaseJson) {
  EXPECT_EQ(shell(kGap + " check " + kExample + "/case.json").said, shell(kGap + " check " + kExample).said);
}

TEST(GapOptions, ALogInPlaceOfACaseIsRefusedWithItsFolder) {
  const Outcome refused = shell(kGap + " check " + kExample + "/fit_1.csv");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, testing::StartsWith("darwinop gap: CASE: " + kExample + "/fit_1.csv is a file"));
  EXPECT_THAT(refused.said, testing::HasSubstr(" " + kExample + "?"));
}

TEST(GapOptions, AFileInAFolderThatIsNotACaseIsRefusedWithoutTheFolder) {
  const TemporaryFolder folder;
  std::ofstream{folder / "notes.txt"} << "x";
  const Outcome refused = shell(kGap + " run " + (folder / "notes.txt"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, testing::HasSubstr("is a file"));
  EXPECT_THAT(refused.said, testing::Not(testing::HasSubstr("?")));
}

TEST(GapOptions, AFolderWithoutLogsAndAMissingOneAreRefusedByWhatTheyAre) {
  const TemporaryFolder folder;
  EXPECT_EQ(shell(kGap + " run " + (folder / "none")).said,
            "darwinop gap: " + (folder / "none") + messages::kNoFolder + "\n");
  EXPECT_EQ(shell(kGap + " run " + (folder / "")).said,
            "darwinop gap: " + (folder / "") + messages::kNeitherCaseNorLogs + "\n");
}

TEST(GapOptions, OfRawLogsAreRefusedForACase) {
  for (const std::string option : {"--declare", "--keep", "--all-logs"}) {
    const std::string value = option == "--all-logs" ? "" : " kp=3";
    const Outcome refused = shell(kGap + " run " + kExample + " " + option + value);
    EXPECT_EQ(refused.status, 2) << option;
    EXPECT_THAT(refused.said, testing::HasSubstr("has a case.json; " + option));
  }
}

// A model file is written with its body, which readers look for beside it.
TEST(GapOptions, AModelThatIsWrittenHasItsBody) {
  const TemporaryFolder folder;
  for (const char* const name : {"own", "other"}) std::filesystem::create_directory(folder / name);
  std::ofstream{folder / "own/model.ini"} << "[model]\nname = own\n[body]\nxml = own.xml\n";
  std::ofstream{folder / "own/own.xml"} << "<mujoco/>";
  const std::string add = " add " + kExample + " --effect coulomb.friction=0.05 --model " + (folder / "own/model.ini");
  const Outcome added = shell(kGap + add + " --out " + (folder / "other/repaired.ini"));
  EXPECT_EQ(added.status, 0) << added.said;
  EXPECT_TRUE(std::filesystem::exists(folder / "other/own.xml"));
  std::ofstream{folder / "other/own.xml"} << "<other/>";
  EXPECT_THAT(shell(kGap + add + " --out " + (folder / "other/repaired.ini")).said,
              testing::HasSubstr(twin::messages::kNotTheBody));
}

TEST(GapOptions, BadInputIsAnObjectForPrograms) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "bad");
  std::ofstream{folder / "bad/case.json"} << "{}";
  const Outcome bad = shell("(" + kGap + " run " + (folder / "bad") + " --json --no-report 2>/dev/null)");
  EXPECT_EQ(bad.status, 2);
  const auto json = nlohmann::json::parse(bad.said);
  EXPECT_EQ(json["case"], "bad");
  EXPECT_EQ(json["verdict"], "bad_input");
  EXPECT_THAT(json["why"].get<std::string>(), testing::HasSubstr("case.json"));
}

TEST(GapOptions, AReportThatCannotBeWrittenIsNotBadInput) {
  const TemporaryFolder folder;
  Case bench = smallBench();
  bench.model.name = "bench";
  writeCase(measured(bench, baselineOf(bench), 7), folder / "case");
  const std::string run = kGap + " run " + (folder / "case") + " --no-open --report ";
  std::ofstream{folder / "file"} << "x";
  const Outcome refused = shell(run + (folder / "file/report"));
  EXPECT_EQ(refused.status, 2) << "before the search";
  EXPECT_THAT(refused.said, testing::HasSubstr((folder / "file") + " is"));
  std::filesystem::create_directories(folder / "report/report.html");  // in place of the page
  const Outcome failed = shell(run + (folder / "report"));
  EXPECT_EQ(failed.status, 1);
  EXPECT_THAT(failed.said, testing::HasSubstr("report/report.html"));
}

// They are refused before the case is read as a whole.
TEST(GapOptions, OfOneServoAreRefusedForAWholeRobot) {
  const TemporaryFolder folder;
  std::ofstream{folder / "case.json"} << R"({"family": "body"})";
  for (const auto& [command, option] : {std::pair{" plan ", " --joint"}, std::pair{" add ", " --effect"}}) {
    const Outcome refused = shell(kGap + command + (folder / "") + option + " ShoulderL");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.said, testing::HasSubstr(option));
  }
}

}  // namespace
}  // namespace darwinop::gap
