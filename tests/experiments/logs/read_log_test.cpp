// Reading logs: formats, warnings, error messages.
#include "experiments/logs/read_log.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "experiments/logs/units.hpp"
#include "hal/text_file.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::logs {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kRecording =
    "# darwinop log, format 1\n# robot: Darwin 7\n# safety.state: 0 limp 1 driven\n"
    "time_s,cycle,Neck.position [rad]\n0.016,1,0.5\n0.032,2,\n0.048,3,-1e-3\n# end\n";

TEST(ReadLog, ReadsARecordingOfTheRuntime) {
  const Log log = parseLog(kRecording, "walk.csv");
  EXPECT_EQ(log.headValue("robot"), "Darwin 7");
  EXPECT_EQ(log.headValue("safety.state"), "0 limp 1 driven");
  EXPECT_FALSE(log.headValue("model"));
  EXPECT_EQ(log.rows(), 3u);
  EXPECT_EQ(log.seconds(1), 0.032);
  EXPECT_EQ(log.column("Neck.position").unit, "rad");
  EXPECT_EQ(log.column("Neck.position").values[2], -1e-3);
  EXPECT_EQ(log.column("cycle").unit, "");
  EXPECT_TRUE(log.complete);
  EXPECT_THAT(log.warnings, IsEmpty());
}

TEST(ReadLog, AnEmptyFieldIsNaN) {
  EXPECT_TRUE(std::isnan(parseLog(kRecording, "").column("Neck.position").values[1]));
  EXPECT_TRUE(std::isnan(parseLog("t_s,a,b\n1,nan, \n", "").column("a").values[0]));
}

TEST(ReadLog, StoresTheLineOfEachRow) {
  EXPECT_THAT(parseLog(kRecording, "").lines, ElementsAre(5, 6, 7));
}

TEST(ReadLog, ReadsPlainCsvWithUnitSuffixes) {
  const Log log = parseLog("t_s,goal_rad,torque_on,speed_rad_s,load_pct,volt_V,temp_C\n0,0.1,1,0,2.3,12,26\n", "");
  std::vector<std::string> units;
  for (const Column& column : log.columns) units.push_back(column.unit);
  EXPECT_THAT(units, ElementsAre("s", "rad", "", "rad/s", "%", "V", "degC"));
  EXPECT_EQ(log.column("goal_rad").values[0], 0.1);
  EXPECT_THAT(log.warnings, IsEmpty()) << "only recordings have an end line";
}

TEST(ReadLog, ConvertsTheTimeUnit) {
  EXPECT_NEAR(parseLog("a,time [ms]\n1,16\n", "").seconds(0), 0.016, 1e-15);
  EXPECT_NEAR(parseLog("t_us\n500\n", "").seconds(0), 5e-4, 1e-15);
}

TEST(ReadLog, AcceptsTheOutputOfSpreadsheets) {
  const Log log = parseLog("\xEF\xBB\xBFt_s,pos_rad\r\n0, +1.5 \r\n\r\n1,2\r\n", "");
  EXPECT_THAT(log.column("pos_rad").values, ElementsAre(1.5, 2));
  EXPECT_THAT(log.lines, ElementsAre(2, 4));
}

TEST(ReadLog, ATruncatedRecordingLosesItsLastRowWithAWarning) {
  // The last number may lack digits, though no field is missing.
  const Log log = parseLog("# darwinop log, format 1\ntime_s,a\n1,10\n2,20\n3,3", "cut.csv");
  EXPECT_EQ(log.rows(), 2u);
  EXPECT_FALSE(log.complete);
  EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("cut.csv, line 5: the file ends in the middle of this row"),
                                        HasSubstr("cut.csv has no \"# end\"")));
}

TEST(ReadLog, PlainCsvMayLackTheLastLineEndButNotFields) {
  EXPECT_EQ(parseLog("t_s,a\n1,10\n2,20", "").rows(), 2u);
  const Log cut = parseLog("t_s,a\n1,10\n2", "");
  EXPECT_EQ(cut.rows(), 1u);
  EXPECT_THAT(cut.warnings, ElementsAre(HasSubstr("line 3")));
}

TEST(ReadLog, WarnsOfLostRows) {
  const Log log =
      parseLog("# darwinop log, format 1\ntime_s\n1\n# lost rows: 88 (the disk was too slow)\n# end\n", "f");
  EXPECT_EQ(log.lost_rows, 88u);
  EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("88 rows were lost")));
}

struct Bad {
  const char *what, *text;
  std::string sentence;
};

class BadLog : public testing::TestWithParam<Bad> {};

TEST_P(BadLog, IsRefusedWithFileLineAndReason) {
  try {
    (void)parseLog(GetParam().text, "walk.csv");
    FAIL() << "the file was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().sentence));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadLog,
    testing::Values(Bad{"Empty", "", "walk.csv, line 1: no header"},
                    Bad{"OnlyComments", "# robot: a\n", "walk.csv, line 1: no header"},
                    Bad{"NoNames", "1,2,3\n", "walk.csv, line 1: no header"},
                    Bad{"Semicolons", "t_s;pos_rad\n", "line 1: fields are separated by \";\""},
                    Bad{"NoTime", "pos_rad\n1\n", "line 1: no time column; name one time_s, t_s"},
                    Bad{"TimeWithoutUnit", "time,a\n", "line 1: column \"time\" needs a time unit"},
                    Bad{"NamelessColumn", "t_s,,b\n", "line 1: a column has no name"},
                    Bad{"TwoOfAName", "t_s,a [rad],a [V]\n", "line 1: two columns are named \"a\""},
                    Bad{"UnknownUnit", "# x\nt_s,a [furlong]\n",
                        "line 2: the unit of column \"a [furlong]\" is unknown; known units: s,"},
                    Bad{"TooFew", "t_s,a,b\n0,1,2\n1,2\n", "walk.csv, line 3: 2 fields, but line 1 names 3 columns"},
                    Bad{"TooMany", "t_s,a\n0,1,2\n", "line 2: 3 fields, but line 1 names 2 columns"},
                    Bad{"NoNumber", "t_s,a\n0,1\n1,abc\n", "line 3: \"abc\" in column \"a\" is not a number"},
                    Bad{"HalfANumber", "t_s,a\n0,1.5rad\n", "line 2: \"1.5rad\" in column \"a\" is not a number"},
                    Bad{"TerminalTricks", "t_s,a\n0,\x1b[2J\n", "line 2: \"?[2J\" in column"},
                    Bad{"TimeUnknown", "t_s,a\n0,1\n,2\n", "line 3: column \"t_s\" is empty"},
                    Bad{"TimeBack", "t_s,a\n2,1\n1,2\n",
                        std::string{"line 3: "} + kTimeGoesBack + ": column \"t_s\" has 1.000000 after 2.000000"},
                    Bad{"TimeStands", "t_s,a\n2,1\n2,2\n", std::string{"line 3: "} + kTimeGoesBack},
                    Bad{"TwoRecordings", "t_s,a\n2,1\n# end\n3,1\n", "line 4: rows after \"# end\""},
                    Bad{"NewerFormat", "# darwinop log, format 2\nt_s\n", "line 1: this log has format \"2\""},
                    Bad{"Utf16", "\xFF\xFEt", "line 1: the text is UTF-16"}),
    [](const auto& each) { return each.param.what; });

TEST(ReadLog, ListsTheColumnsIfOneIsMissing) {
  try {
    (void)parseLog("t_s,pos_rad\n", "walk.csv").column("pos");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "walk.csv: no column \"pos\"; available: t_s, pos_rad");
  }
}

TEST(ReadLog, RefusesWhatIsNotARegularFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const auto& [path, why] : {std::pair<std::string, std::string>{folder / "none.csv", std::strerror(ENOENT)},
                                  {folder / ".", kFolderInsteadOfFile},
                                  {folder / "pipe", kPipeInsteadOfFile},
                                  {"/dev/zero", kDeviceInsteadOfFile}})
    try {
      (void)readLog(path);
      FAIL() << path;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(path + ": " + why));
    }
}

TEST(ReadLog, RefusesAFileThatIsTooLong) {
  const TemporaryFolder folder;
  const std::string path = folder / "long.csv";
  std::ofstream{path} << "t_s,a\n";
  std::filesystem::resize_file(path, kLongestLog + 1);  // sparse: occupies no disk
  try {
    (void)readLog(path);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(path), HasSubstr(std::to_string(kLongestLog))));
  }
}

TEST(ReadLog, ReadsAFileOfManyBlocks) {
  const TemporaryFolder folder;
  constexpr int kRows = 20'000;  // 0.5 MB: many read blocks
  {
    std::ofstream file{folder / "long.csv"};
    file << "t_ms,a,b\n";
    for (int i = 0; i < kRows; ++i) file << i << ',' << 2 * i << ",0.123456789\n";
  }
  const Log log = readLog(folder / "long.csv");
  ASSERT_EQ(log.rows(), std::size_t{kRows});
  for (std::size_t i = 0; i < kRows; ++i) ASSERT_EQ(log.columns[1].values[i], 2.0 * static_cast<double>(i));
  EXPECT_EQ(log.lines.back(), kRows + 1u);
}

TEST(Units, TheLongestMatchingSuffixIsUsed) {
  EXPECT_EQ(unitOfSuffix("speed_rad_s"), "rad/s");
  EXPECT_EQ(withoutSuffix("speed_rad_s"), "speed");
  EXPECT_EQ(unitOfSuffix("torque_on"), "");
  EXPECT_EQ(withoutSuffix("torque_on"), "torque_on");
  EXPECT_EQ(unitOfSuffix("rad"), "") << "a name, not a unit";
}

}  // namespace
}  // namespace darwinop::logs
