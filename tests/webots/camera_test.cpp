// What a controller gets to see: pictures as they come, in the size that was promised, and nothing stale.
#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <vector>
#include <webots/Camera.hpp>

#include "webots/fixture.hpp"

namespace darwinop::webots_api {
namespace {

using testing::HasSubstr;

/// What the camera gives; the test changes it while the controller runs.
struct Scene {
  int width = 320, height = 240;
  std::uint64_t sequence = 0;
  std::uint8_t blue = 0;
  bool seeing = true;
  int asked = 0;
};

class SceneSource final : public FrameSource {
 public:
  explicit SceneSource(Scene& scene) : scene_{scene} {}
  CameraFrame newest() override {
    ++scene_.asked;
    bytes_.resize(4 * static_cast<std::size_t>(scene_.width) * static_cast<std::size_t>(scene_.height));
    for (std::size_t i = 0; i < bytes_.size(); i += 4) {
      bytes_[i] = scene_.blue;
      bytes_[i + 1] = static_cast<std::uint8_t>(i / 4 % static_cast<std::size_t>(scene_.width) / 2);  // column
      bytes_[i + 2] = static_cast<std::uint8_t>(i / 4 / static_cast<std::size_t>(scene_.width));      // row
      bytes_[i + 3] = 255;
    }
    return {scene_.sequence, Nanos{0}, scene_.width, scene_.height, bytes_};
  }
  [[nodiscard]] CameraHealth health() const override { return {.seeing = scene_.seeing}; }

 private:
  Scene& scene_;
  std::vector<std::uint8_t> bytes_;
};

class CameraTest : public Facade {
 protected:
  CameraTest() {
    fake.open_camera = [this](int width, int height) {
      opened_.push_back({width, height});
      return std::make_unique<SceneSource>(scene_);
    };
  }

  webots::Camera& camera() { return *robot().getCamera("Camera"); }
  /// Blue of the first pixel; after a step.
  int seen() {
    EXPECT_EQ(robot().step(16), 0);
    return camera().getImage()[0];
  }
  void show(std::uint8_t blue) {
    scene_.blue = blue;
    ++scene_.sequence;
  }

  Scene scene_;
  std::vector<std::pair<int, int>> opened_;
};

TEST_F(CameraTest, HasNoPictureWhileDisabled) {
  show(7);
  EXPECT_EQ(camera().getImage(), nullptr);
  (void)robot().step(16);
  EXPECT_EQ(camera().getImage(), nullptr);
  EXPECT_TRUE(opened_.empty()) << "nobody asked for it";
  camera().enable(16);
  EXPECT_EQ(seen(), 7);
  camera().disable();
  EXPECT_EQ(camera().getImage(), nullptr);
  EXPECT_EQ(camera().getSamplingPeriod(), 0);
  camera().enable(0);
  EXPECT_EQ(camera().getImage(), nullptr);
}

TEST_F(CameraTest, IsOpenedOnceInTheConfiguredSize) {
  config.camera_width = 640;
  config.camera_height = 480;
  scene_.width = 640;
  scene_.height = 480;
  camera().enable(16);
  camera().enable(32);
  show(9);
  EXPECT_EQ(seen(), 9);
  EXPECT_EQ(opened_, (std::vector<std::pair<int, int>>{{640, 480}}));
  EXPECT_EQ(camera().getWidth(), 640);
  EXPECT_EQ(camera().getHeight(), 480);
  const unsigned char* const image = camera().getImage();
  EXPECT_EQ(webots::Camera::imageGetRed(image, 640, 500, 200), 200);
  EXPECT_EQ(webots::Camera::imageGetGreen(image, 640, 500, 200), 250);
  EXPECT_EQ(webots::Camera::imageGetBlue(image, 640, 500, 200), 9);
}

TEST_F(CameraTest, IsBlackUntilTheFirstPictureHasCome) {
  camera().enable(16);
  const unsigned char* const before = camera().getImage();
  ASSERT_NE(before, nullptr) << "controllers read it before their first step";
  EXPECT_EQ(before[0], 0);
  EXPECT_EQ(before[3], 255);
  scene_.blue = 200;  // its buffer has something, but no frame has come
  EXPECT_EQ(seen(), 0);
  show(200);
  EXPECT_EQ(seen(), 200);
}

/// In 2013 there was one buffer for all pictures.
TEST_F(CameraTest, APointerThatIsKeptShowsEachNewPicture) {
  camera().enable(16);
  const unsigned char* const image = camera().getImage();
  for (const int width : {320, 320, 160}) {
    scene_.width = width;
    scene_.height = width * 3 / 4;
    scene_.seeing = true;
    show(static_cast<std::uint8_t>(scene_.sequence + 7));
    EXPECT_EQ(seen(), image[0]);
    EXPECT_EQ(image[0], scene_.blue);
    scene_.seeing = false;
    EXPECT_EQ(seen(), 0);
    EXPECT_EQ(image[0], 0) << "stale";
    EXPECT_EQ(image[3], 255);
  }
}

TEST_F(CameraTest, KeepsAPictureAsItIsWithinAStep) {
  camera().enable(16);
  show(1);
  EXPECT_EQ(seen(), 1);
  const int asked = scene_.asked;
  show(2);
  EXPECT_EQ(camera().getImage()[0], 1);
  EXPECT_EQ(scene_.asked, asked);
  EXPECT_EQ(seen(), 2);
}

TEST_F(CameraTest, TakesAPictureEverySamplingPeriod) {
  camera().enable(48);
  show(1);
  EXPECT_EQ(seen(), 1);
  show(2);
  EXPECT_EQ(seen(), 1);
  EXPECT_EQ(seen(), 1);
  EXPECT_EQ(seen(), 2);
}

TEST_F(CameraTest, APeriodBetweenTwoStepsIsRightOnAverage) {
  camera().enable(40);
  show(1);
  for (int step = 0; step < 100; ++step) (void)seen();
  EXPECT_NEAR(scene_.asked, 40, 1);
}

TEST_F(CameraTest, IsBlackWhileTheCameraIsSilent) {
  camera().enable(16);
  show(50);
  EXPECT_EQ(seen(), 50);
  scene_.seeing = false;
  EXPECT_EQ(seen(), 0) << "a ball that was there 2 s ago is none";
  scene_.seeing = true;
  show(51);
  EXPECT_EQ(seen(), 51);
}

TEST_F(CameraTest, StretchesWhatComesInAnotherSizeAndReportsItOnce) {
  config.camera_width = 640;
  config.camera_height = 480;
  camera().enable(16);
  show(3);
  testing::internal::CaptureStderr();
  EXPECT_EQ(seen(), 3);
  EXPECT_EQ(seen(), 3);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::ranges::count(said, '\n'), 1);
  EXPECT_THAT(said, HasSubstr("320x240 are stretched to 640x480"));
  EXPECT_THAT(said, HasSubstr("camera_width = 320"));
  const unsigned char* const image = camera().getImage();
  EXPECT_EQ(webots::Camera::imageGetRed(image, 640, 0, 479), 239);
  EXPECT_EQ(webots::Camera::imageGetGreen(image, 640, 639, 0), 319 / 2);
}

TEST_F(CameraTest, ARobotWithoutEyesSaysSoAndTheControllerGoesOn) {
  fake.open_camera = [](int, int) -> std::unique_ptr<FrameSource> { throw std::runtime_error("it has no head"); };
  testing::internal::CaptureStderr();
  camera().enable(16);
  EXPECT_EQ(seen(), 0);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("Camera: every picture is black: it has no head"));
}

TEST_F(CameraTest, ALockstepRobotNeverOpensTheCameraOfThisComputer) {
  fake.open_camera = {};
  fake.real_time = false;
  testing::internal::CaptureStderr();
  camera().enable(16);
  EXPECT_EQ(seen(), 0);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("--robot twin"));
}

}  // namespace
}  // namespace darwinop::webots_api
