// Recordings of an earlier run are kept only if they are what is to be recorded.
#include "gap/record/kept_recording.hpp"

#include <gtest/gtest.h>

#include "experiments/logs/read_log.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {
namespace {

const std::string kHead =
    "# darwinop log, format 1\n# robot: darwin-op\n# model: /dev/ttyUSB0\n# date: 2026-11-28T09:38:26Z\n"
    "# experiment: body_sines\n";
const std::string kRows = "time_s,a\n1,2\n", kEnd = "# end\n";

double beginIn(const std::string& text, const std::string& twin = "") {
  PlannedRecording plan;
  plan.experiment = "body_sines";
  return beginOf(logs::parseLog(text, "upright.csv"), plan, twin);
}

TEST(KeptRecording, BeganAtItsDate) {
  EXPECT_EQ(beginIn(kHead + kRows + kEnd), 1795858706);
}

TEST(KeptRecording, IsRefusedIfItIsSomethingElse) {
  EXPECT_THROW((void)beginIn(kRows), BadInput) << "not a recording";
  EXPECT_THROW((void)beginIn(kHead + kRows), BadInput) << "cut off";
  std::string other = kHead;
  other.replace(other.find("body_sines"), 10, "body_chirp");
  EXPECT_THROW((void)beginIn(other + kRows + kEnd), BadInput);
}

TEST(KeptRecording, IsRefusedIfItIsOfAnotherRobot) {
  EXPECT_THROW((void)beginIn(kHead + kRows + kEnd, "twin in memory, model darwin-op"), BadInput);
  std::string of_twin = kHead;
  of_twin.replace(of_twin.find("/dev/ttyUSB0"), 12, "twin in memory, model stiff-elbow.ini");
  EXPECT_NO_THROW((void)beginIn(of_twin + kRows + kEnd, "twin in memory, model stiff-elbow.ini"));
  EXPECT_THROW((void)beginIn(of_twin + kRows + kEnd, "twin in memory, model darwin-op"), BadInput);
  EXPECT_THROW((void)beginIn(of_twin + kRows + kEnd), BadInput);
}

TEST(KeptRecording, TheSessionGoesOnByTheClockUnlessThatWasSetBack) {
  EXPECT_EQ(sessionAge(1000, 1600, 1600), 600);
  EXPECT_EQ(sessionAge(1000, 1600, 90'000), 89'000) << "a day later";
  EXPECT_THROW((void)sessionAge(1000, 1600, 1500), BadInput);
}

TEST(KeptRecording, AnHourLaterItIsAnotherSession) {
  EXPECT_EQ(pauseText(3000), "");
  EXPECT_NE(pauseText(7200).find(messages::kAnotherSession), std::string::npos);
}

}  // namespace
}  // namespace darwinop::gap
