// config.ini: the liberties files take, defaults, warnings, errors.
#include "webots/config_ini.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace darwinop::facade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kSound = "[Robot Config]\ntime_step=8\ncamera_width=640\ncamera_height=480\n";

std::string errorOf(const std::string& text) {
  try {
    static_cast<void>(parseConfig(text, "config.ini"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ConfigIni, ReadsTheRobotConfig) {
  const ConfigReading reading = parseConfig(kSound, "config.ini");
  EXPECT_EQ(reading.config.time_step_ms, 8);
  EXPECT_EQ(reading.config.camera_width, 640);
  EXPECT_EQ(reading.config.camera_height, 480);
  EXPECT_THAT(reading.warnings, IsEmpty());
}

TEST(ConfigIni, AnEmptyFileGivesTheDefaultsAndSaysSo) {
  const ConfigReading reading = parseConfig("", "config.ini");
  EXPECT_EQ(reading.config.time_step_ms, 16);
  EXPECT_EQ(reading.config.camera_width, 320);
  EXPECT_THAT(reading.warnings, ElementsAre(HasSubstr("Can't read time step from 'config.ini'"),
                                            HasSubstr("Can't read camera size from 'config.ini'")));
}

TEST(ConfigIni, AMissingFileGivesTheDefaultsAndSaysSo) {
  const ConfigReading reading = readConfig("/nowhere/config.ini");
  EXPECT_EQ(reading.config.time_step_ms, 16);
  EXPECT_THAT(reading.warnings, ElementsAre(HasSubstr("there is no /nowhere/config.ini")));
}

TEST(ConfigIni, TheLibertiesThatFilesTakeSince2013AreUnderstood) {
  for (const char* text :
       {"[Robot Config]\ntime_step=24", "[robot config]\nTIME_STEP = 24\n", "[Robot Config]\ntime_step : 24\n",
        "[Robot Config]\ntime_step = 24.0; text\n", "[Robot Config]\ntime_step = 24 # text\n",
        "[Robot Config]\ntime_step = \"24\" ; text\n", "[Robot Config]\r\ntime_step = 24\r\n",
        "  [Robot Config]  \n   time_step = 24\n", "[Robot Config] ; here\n; time_step = 3\n# x\n\ntime_step=24",
        "\xEF\xBB\xBF[Robot Config]\ntime_step=24\n", "[Camera]\nGain = 3\n[Robot Config]\n\ttime_step\t=\t24.9",
        "[Robot Config]\ncamera_width = 320\n  camera_height = 240\n  time_step = 24\n"})
    EXPECT_EQ(parseConfig(text, "config.ini").config.time_step_ms, 24) << text;
}

TEST(ConfigIni, SectionsOfOtherPartsAreAcceptedInSilence) {
  const std::string text = kSound + "[Walking Config]\nx_offset=-10\n[Camera]\nGain=255\n[Offset]\nID_01=0\n";
  EXPECT_THAT(parseConfig(text, "config.ini").warnings, IsEmpty());
}

TEST(ConfigIni, AnUnknownKeyIsNamedWithFileAndLine) {
  const ConfigReading reading = parseConfig(kSound + "tme_step = 3\n", "/home/darwin/config.ini");
  EXPECT_THAT(
      reading.warnings,
      ElementsAre("/home/darwin/config.ini, line 5: key \"tme_step\" of section [Robot Config] means nothing to "
                  "this version; it is ignored"));
}

TEST(ConfigIni, ALineThatIsNothingIsNamed) {
  EXPECT_THAT(parseConfig(kSound + "time step\n", "config.ini").warnings, ElementsAre(HasSubstr("line 5")));
}

TEST(ConfigIni, ALineThatIsTooLongIsAnErrorAndNotCutInSilence) {
  EXPECT_EQ(errorOf(kSound + "\ntime_step = " + std::string(200, '1') + "\n"),
            "config.ini, line 6: the line is too long");
  EXPECT_EQ(errorOf(kSound + "time_step = 16 ; " + std::string(900, '1') + "\n"), "no error");
}

TEST(ConfigIni, AnImpossibleCameraSizeBecomesTheDefault) {
  const ConfigReading reading =
      parseConfig("[Robot Config]\ntime_step=16\ncamera_width=160\ncamera_height=120\n", "config.ini");
  EXPECT_EQ(reading.config.camera_width, 320);
  EXPECT_EQ(reading.config.camera_height, 240);
  EXPECT_THAT(reading.warnings, ElementsAre(HasSubstr("160x120")));
}

TEST(ConfigIni, ABadNumberIsAnErrorWithFileLineKeyAndRange) {
  for (const char* bad : {"fast", "16 ms", "0", "-16", "1e9", "nan", "inf", "", "-1024"})
    EXPECT_EQ(errorOf(std::string{"[Robot Config]\n\ntime_step = "} + bad),
              std::string{"config.ini, line 3: time_step = "} + bad + ": give a number from 1 to 10000");
}

TEST(ConfigIni, SafetySettingsReachTheSafetyLayer) {
  const safety::Config safety =
      parseConfig(kSound + "[Safety]\nStall_ms = 250\non_fall = limp\n[Limits]\nneck = -0.5, 0.5\n", "x").config.safety;
  EXPECT_EQ(safety.stall_ms, 250);
  EXPECT_EQ(safety.on_fall, safety::OnFall::kLimp);
  EXPECT_EQ(safety.range[index(Joint::kNeck)].high.value, 0.5);
}

TEST(ConfigIni, ASafetySettingThatIsWrongIsAnError) {
  EXPECT_THAT(errorOf("[Safety]\nstall_ms = never\n"), HasSubstr("config.ini, line 2: "));
  EXPECT_THAT(errorOf("[Safety]\nstal_ms = 5\n"), HasSubstr("stal_ms"));
  EXPECT_THAT(errorOf("[Safety]\nbattery_low = 9\n"), HasSubstr("battery_empty")) << "the two contradict each other";
  EXPECT_THAT(errorOf("[Limits]\nNose = 0, 1\n"), HasSubstr("Nose"));
}

}  // namespace
}  // namespace darwinop::facade
