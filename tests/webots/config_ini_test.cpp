// config.ini: the liberties files take, defaults, warnings, errors.
#include "webots/config_ini.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "hal/text_file.hpp"

namespace darwinop::webots_api {
namespace {

using testing::AllOf;
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
  EXPECT_THAT(reading.warnings, ElementsAre(AllOf(HasSubstr("/home/darwin/config.ini, line 5: "),
                                                  HasSubstr("\"tme_step\""), HasSubstr("[Robot Config]"))));
}

TEST(ConfigIni, ALineThatIsNothingIsNamed) {
  EXPECT_THAT(parseConfig(kSound + "time step\n", "config.ini").warnings, ElementsAre(HasSubstr("line 5")));
}

TEST(ConfigIni, ALineThatIsTooLongIsAnErrorAndNotCutInSilence) {
  EXPECT_EQ(errorOf(kSound + "\ntime_step = " + std::string(200, '1') + "\n"),
            "config.ini, line 6: the line is too long");
  EXPECT_EQ(errorOf(kSound + "time_step = 16 ; " + std::string(900, '1') + "\n"), "no error");
}

TEST(ConfigIni, TheCameraHasSettings) {
  const ConfigReading reading =
      parseConfig(kSound +
                      "[Camera]\nBrightness=128\ncontrast = 32\nSATURATION=28.0\nGain=-1\nExposure = 10000\n"
                      "Auto_White_Balance = ON\nauto_gain = off\n",
                  "config.ini");
  EXPECT_TRUE(reading.config.camera.auto_white_balance);
  EXPECT_FALSE(reading.config.camera.auto_gain);
  EXPECT_FALSE(reading.config.camera.auto_exposure);
  EXPECT_EQ(reading.config.camera.brightness, 128);
  EXPECT_EQ(reading.config.camera.contrast, 32);
  EXPECT_EQ(reading.config.camera.saturation, 28);
  EXPECT_EQ(reading.config.camera.gain, v4l2::CameraSettings::kDriversDefault);
  EXPECT_EQ(reading.config.camera.exposure, 10000);
  EXPECT_THAT(reading.warnings, IsEmpty());
}

TEST(ConfigIni, AnOffsetOf2013IsReportedWithItsPlaceInRobotIni) {
  EXPECT_THAT(parseConfig(kSound + "[Offset]\nID_11 = -12\nID_01 = 0\n", "config.ini").warnings,
              ElementsAre(AllOf(HasSubstr("ID_11 = -12"), HasSubstr(messages::kOffsetsAreTheRobots),
                                HasSubstr("LegUpperR = -0.0184"))));
}

TEST(ConfigIni, OfAKeyThatIsThereTwiceTheFirstCountsAsIn2013) {
  const ConfigReading reading = parseConfig(
      "[Robot Config]\ntime_step = 16\nTime_Step = 32\ncamera_width = 320\n"
      "camera_height = 240\n",
      "config.ini");
  EXPECT_EQ(reading.config.time_step_ms, 16);
  EXPECT_THAT(reading.warnings, ElementsAre(AllOf(HasSubstr("line 3"), HasSubstr("line 2"))));
}

TEST(ConfigIni, ACameraSettingThatIsNotThereKeepsItsDefault) {
  const ConfigReading reading = parseConfig(kSound + "[Camera]\nGain = -2\n", "config.ini");
  EXPECT_EQ(reading.config.camera.gain, 255);
  EXPECT_EQ(reading.config.camera.exposure, 1000);
  EXPECT_EQ(reading.config.camera.brightness, v4l2::CameraSettings::kDriversDefault);
}

TEST(ConfigIni, AWrongCameraSettingIsNamed) {
  for (const char* wrong : {"Gain = 256", "Exposure = -3", "Contrast = high", "Brightness = nan"})
    EXPECT_THAT(errorOf(kSound + "[Camera]\n" + wrong),
                AllOf(HasSubstr("config.ini, line 6"), HasSubstr(wrong), HasSubstr("-1")));
  EXPECT_THAT(errorOf(kSound + "[Camera]\nAuto_gain = 1\n"),
              AllOf(HasSubstr("Auto_gain = 1: "), HasSubstr("on"), HasSubstr("off")));
  EXPECT_THAT(parseConfig(kSound + "[Camera]\nZoom = 3\n", "config.ini").warnings,
              ElementsAre(AllOf(HasSubstr("Zoom"), HasSubstr("Saturation"))));
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

TEST(ConfigIni, ASettingOfSafetyInAnotherSectionIsAnErrorAndNotIgnored) {
  EXPECT_THAT(errorOf("[Saftey]\nStall_ms = 250\n"),
              AllOf(HasSubstr("line 2: "), HasSubstr("\"Stall_ms\""), HasSubstr("[Saftey]"), HasSubstr("[Safety]")));
  EXPECT_THAT(errorOf("[Limit]\nneck = -0.5, 0.5\n"),
              AllOf(HasSubstr("\"neck\""), HasSubstr("[Limit]"), HasSubstr("[Limits]")));
  EXPECT_THAT(errorOf("Neck = -0.5, 0.5\n"), HasSubstr("line 1"));
  EXPECT_THAT(errorOf("[Robot Config]\non_exit = limp\n"), HasSubstr("on_exit"));
  EXPECT_EQ(errorOf("[My Game]\nnose = 1\n"), "no error");
}

TEST(ConfigIni, ASectionWithoutItsClosingBracketIsAnError) {
  const std::string expected = "config.ini, line 5: the section's closing bracket ] is missing";
  EXPECT_EQ(errorOf(kSound + "[Limits\nNeck = -0.5, 0.5\n"), expected);
  EXPECT_EQ(errorOf(kSound + "[Limits ; ]\nNeck = -0.5, 0.5\n"), expected);
  EXPECT_EQ(errorOf("\xEF\xBB\xBF[Limits\n"), "config.ini, line 1: the section's closing bracket ] is missing");
}

TEST(ConfigIni, AKeyBehindItsSectionIsAnErrorAndNotIgnored) {
  EXPECT_EQ(errorOf("[Limits] Neck = -0.5, 0.5\n"), "config.ini, line 1: put the key into a line of its own");
}

TEST(ConfigIni, ALimitWithoutAnEqualsSignIsAnError) {
  EXPECT_EQ(errorOf("[Limits]\nNeck -0.5, 0.5\n"), "config.ini, line 2: \"Neck -0.5, 0.5\" is not key = value");
  EXPECT_EQ(errorOf("[safety]\non_exit limp\n"), "config.ini, line 2: \"on_exit limp\" is not key = value");
}

TEST(ConfigIni, EveryLineThatIsNothingIsNamed) {
  EXPECT_EQ(parseConfig(kSound + "a b\nc d\n", "config.ini").warnings.size(), 2u);
}

TEST(ConfigIni, AnErrorNamesTheFileOnce) {
  for (const char* text : {"[Safety]\nstall_ms = never\n", "[Limits]\nNeck = 1, 0\n", "[Safety]\nbattery_low = 9\n"}) {
    const std::string error = errorOf(text);
    EXPECT_THAT(error, testing::StartsWith("config.ini, "));
    EXPECT_EQ(error.find("config.ini", 1), std::string::npos) << error;
  }
}

TEST(ConfigIni, AFileThatCannotBeReadIsAnErrorAndNotTakenForAbsent) {
  const std::string path = testing::TempDir() + "darwinop_config_" + std::to_string(getpid());
  const auto error = [&] {
    try {
      static_cast<void>(readConfig(path));
    } catch (const std::runtime_error& wrong) {
      return std::string{wrong.what()};
    }
    return std::string{"no error"};
  };
  std::filesystem::create_directory(path);
  EXPECT_THAT(error(), AllOf(HasSubstr(path), HasSubstr(kFolderInsteadOfFile)));
  std::filesystem::remove(path);
  std::filesystem::create_symlink(path, path);
  EXPECT_THAT(error(), AllOf(HasSubstr(path), HasSubstr(std::strerror(ELOOP))));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace darwinop::webots_api
