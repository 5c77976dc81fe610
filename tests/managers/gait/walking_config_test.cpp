// [Walking Config]: keys, ranges, warnings and errors.
#include "managers/gait/walking_config.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace darwinop::gait {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

WalkingConfig read(const std::string& lines) {
  return parseWalkingConfig("[Walking Config]\n" + lines, "gait.ini");
}

std::string errorOf(const std::string& lines) {
  try {
    read(lines);
  } catch (const std::runtime_error& wrong) {
    return wrong.what();
  }
  return "no error";
}

TEST(WalkingConfigFile, OfAKeyThatIsThereTwiceTheFirstCountsAsIn2013) {
  const WalkingConfig got = read("period_time = 600\nPeriod_Time = 800\n");
  EXPECT_EQ(got.parameters.period_time, 600);
  EXPECT_THAT(got.warnings, ElementsAre(testing::AllOf(HasSubstr("line 3"), HasSubstr("line 2"))));
}

TEST(WalkingConfigFile, EveryKeySetsItsField) {
  for (const ParameterRow& row : kParameters) {
    for (double value : {row.low, row.high, (row.low + 3 * row.high) / 4}) {
      const Parameters got = read(std::string{row.name} + " = " + std::to_string(value)).parameters;
      for (const ParameterRow& other : kParameters)
        EXPECT_NEAR(got.*other.field, &other == &row ? value : Parameters{}.*other.field, 1e-6) << row.name;
    }
    EXPECT_GE(Parameters{}.*row.field, row.low) << row.name;
    EXPECT_LE(Parameters{}.*row.field, row.high) << row.name;
  }
}

TEST(WalkingConfigFile, AcceptsExistingFiles) {
  const WalkingConfig got = parseWalkingConfig(
      "[Robot Config]\ntime_step = 16\nx_offset = 5\n"
      "[WALKING config]\nX_Offset = \"-12.5\" ; mm\nfoot_height : 35;no space\n\nz_offset = -1024\nIK = Exact\n"
      "[Limits]\nNeck = -1 1\n",
      "config.ini");
  EXPECT_THAT(got.warnings, IsEmpty());
  EXPECT_EQ(got.parameters.x_offset, -12.5);
  EXPECT_EQ(got.parameters.foot_height, 35);
  EXPECT_EQ(got.parameters.z_offset, 20);
  EXPECT_EQ(got.parameters.ik, Ik::kExact);
  EXPECT_EQ(read("ik = flawed").parameters.ik, Ik::kFlawed);
  EXPECT_EQ(Parameters{}.ik, Ik::kFlawed);
}

TEST(WalkingConfigFile, ReportsValuesOutOfRange) {
  EXPECT_EQ(errorOf("\nperiod_time = 60"), "gait.ini, line 3: period_time = 60: give a number from 240 to 3000 (ms)");
  EXPECT_EQ(errorOf("dsp_ratio = 0.9"), "gait.ini, line 2: dsp_ratio = 0.9: give a number from 0 to 0.8 (-)");
  for (const char* line : {"x_offset = ten", "x_offset =", "x_offset = nan", "x_offset = 1e9", "x_offset = 3 mm"})
    EXPECT_THAT(errorOf(line), HasSubstr("gait.ini, line 2: x_offset = ")) << line;
  EXPECT_EQ(errorOf("ik = half"), "gait.ini, line 2: ik = half: give flawed or exact");
}

TEST(WalkingConfigFile, WarnsOfUnknownKeys) {
  EXPECT_THAT(read("foot_heigth = 30\nwalk!\ni_gain = 3\n").warnings,
              ElementsAre("gait.ini, line 2: key \"foot_heigth\" of section [Walking Config] is unknown; it is "
                          "ignored",
                          "gait.ini, line 3: is neither key = value nor a comment; it is ignored",
                          "gait.ini, line 4: key \"i_gain\" has no effect on this robot; only p_gain has"));
}

TEST(WalkingConfigFile, AMissingFileGivesTheDefaults) {
  const TemporaryFolder folder;
  const std::string path = folder / "config.ini";
  EXPECT_THAT(readWalkingConfig(path).warnings, ElementsAre(testing::HasSubstr(path)));
  std::ofstream{path} << "[Walking Config]\nfoot_height = 25\n";
  EXPECT_EQ(readWalkingConfig(path).parameters.foot_height, 25);
}

TEST(WalkingConfigFile, AnEmptyNameGivesTheDefaultsAndIsNamedAsSuch) {
  const WalkingConfig config = readWalkingConfig("");
  EXPECT_THAT(config.warnings, ElementsAre(kNoConfigName));
  EXPECT_EQ(config.parameters.foot_height, Parameters{}.foot_height);
}

TEST(WalkingConfigFile, AnEmptyKeyIsReportedWithItsLine) {
  for (const char* line : {"\"\" = 3", "= 3"})
    EXPECT_THAT(read(line).warnings, ElementsAre(HasSubstr("gait.ini, line 2"))) << line;
}

}  // namespace
}  // namespace darwinop::gait
