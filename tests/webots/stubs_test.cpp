// The speaker: harmless, and it says once that it is not there yet. Small things.
#include <gmock/gmock.h>

#include <DARwInOPDirectoryManager.hpp>
#include <RobotisOp2DirectoryManager.hpp>
#include <webots/Camera.hpp>
#include <webots/Speaker.hpp>

#include "fixture.hpp"

namespace darwinop::facade {
namespace {

/// What is said on stderr from here to the end.
class StubTest : public Facade {
 protected:
  StubTest() {
    robot();
    testing::internal::CaptureStderr();
  }
  static long lines(const std::string& text) { return std::ranges::count(text, '\n'); }
};

TEST_F(StubTest, PixelsAreReadAsBlueGreenRed) {
  const unsigned char pixels[] = {1, 2, 3, 255, 10, 20, 30, 255};
  EXPECT_EQ(webots::Camera::imageGetRed(pixels, 2, 1, 0), 30);
  EXPECT_EQ(webots::Camera::imageGetGreen(pixels, 2, 1, 0), 20);
  EXPECT_EQ(webots::Camera::imageGetBlue(pixels, 2, 1, 0), 10);
  EXPECT_EQ(webots::Camera::imageGetGrey(pixels, 2, 1, 0), 19);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(StubTest, TheSpeakerIsSilentInBothStyles) {
  webots::Speaker& speaker = *robot().getSpeaker("Speaker");
  speaker.speak("hello", "en", 120);
  speaker.speak("hello");
  speaker.speak("hello", 1.0);
  speaker.playFile("x.wav");
  webots::Speaker::playSound(&speaker, &speaker, "x.wav", 1, 1, 0, false);
  EXPECT_FALSE(speaker.isSpeaking());
  EXPECT_EQ(lines(testing::internal::GetCapturedStderr()), 1);
}

TEST_F(StubTest, EachRobotHasItsDataDirectory) {
  EXPECT_EQ(managers::DARwInOPDirectoryManager::getDataDirectory(), "/darwin/Data/");
  EXPECT_EQ(managers::RobotisOp2DirectoryManager::getDataDirectory(), "/robotis/Data/");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace darwinop::facade
