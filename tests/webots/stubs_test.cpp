// Small things.
#include <gmock/gmock.h>

#include <DARwInOPDirectoryManager.hpp>
#include <RobotisOp2DirectoryManager.hpp>
#include <webots/Camera.hpp>

#include "fixture.hpp"

namespace darwinop::webots_api {
namespace {

/// Output on stderr from here to the end.
class StubTest : public Facade {
 protected:
  StubTest() {
    robot();
    testing::internal::CaptureStderr();
  }
};

TEST_F(StubTest, PixelsAreReadAsBlueGreenRed) {
  const unsigned char pixels[] = {1, 2, 3, 255, 10, 20, 30, 255};
  EXPECT_EQ(webots::Camera::imageGetRed(pixels, 2, 1, 0), 30);
  EXPECT_EQ(webots::Camera::imageGetGreen(pixels, 2, 1, 0), 20);
  EXPECT_EQ(webots::Camera::imageGetBlue(pixels, 2, 1, 0), 10);
  EXPECT_EQ(webots::Camera::imageGetGrey(pixels, 2, 1, 0), 19);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(StubTest, EachRobotHasItsDataDirectory) {
  EXPECT_EQ(managers::DARwInOPDirectoryManager::getDataDirectory(), "/darwin/Data/");
  EXPECT_EQ(managers::RobotisOp2DirectoryManager::getDataDirectory(), "/robotis/Data/");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace darwinop::webots_api
