// A device that is absent or not a camera.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/camera_error.hpp"
#include "hal/camera_v4l2/device.hpp"
#include "hal/camera_v4l2/picture.hpp"
#include "hal/pixels/yuyv_to_bgra.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::v4l2 {
namespace {

using namespace std::chrono_literals;

CameraError errorWith(const std::string& path) {
  try {
    const V4l2Device device{path};
  } catch (const CameraRefused& refused) {
    EXPECT_THAT(refused.what(), testing::HasSubstr(path));
    return refused.kind();
  }
  ADD_FAILURE() << path << " was taken for a camera";
  return CameraError::kOther;
}

TEST(AbsentCamera, IsDistinguishedFromOtherFiles) {
  const TemporaryFolder folder;
  EXPECT_EQ(errorWith(folder / "video0"), CameraError::kAbsent);
  EXPECT_EQ(errorWith("/dev/null"), CameraError::kNotACamera);
  EXPECT_EQ(errorWith("/tmp"), CameraError::kNotACamera);
}

/// The thread has ended, and was not abandoned, if only the test holds the token after the camera's destruction. On a
/// busy computer this may take longer than on the robot.
constexpr auto kGrace = 20s;

TEST(AbsentCamera, IsBlackAndLeavesPromptly) {
  const TemporaryFolder folder;
  const auto token = std::make_shared<int>(0);
  std::atomic<int> said{0};
  CameraOptions options;
  options.device = folder / "video0";
  options.width = 64;
  options.height = 48;
  options.log = [token, &said](const std::string&) {
    ++said;
    throw std::runtime_error("a listener that throws");
  };
  options.patience.first_pause = options.patience.longest_pause = 1ms;
  options.patience.grace = kGrace;
  auto camera = std::make_unique<Camera>(options);
  options.log = nullptr;
  const CameraFrame frame = camera->newest();
  EXPECT_EQ(frame.sequence, 0u);
  EXPECT_EQ(frame.width, 64);
  EXPECT_EQ(frame.height, 48);
  ASSERT_EQ(frame.bgra.size(), 4u * 64 * 48);
  for (std::size_t i = 0; i < frame.bgra.size(); ++i) ASSERT_EQ(frame.bgra[i], i % 4 == 3 ? 255 : 0);
  while (said == 0) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(30ms);  // many more attempts
  EXPECT_EQ(said, 1);
  EXPECT_FALSE(camera->health().seeing);
  EXPECT_EQ(camera->health().reopened, 0u);
  camera.reset();
  EXPECT_EQ(token.use_count(), 1);
}

TEST(AbsentCamera, DoesNotBlockItsOwnerDuringALongPause) {
  const TemporaryFolder folder;
  CameraOptions options;
  options.device = folder / "video0";
  options.patience.first_pause = options.patience.longest_pause = 60s;
  options.patience.grace = kGrace;
  const auto token = std::make_shared<int>(0);
  std::atomic<bool> said{false};
  options.log = [token, &said](const std::string&) { said = true; };
  auto camera = std::make_unique<Camera>(options);
  options.log = nullptr;
  while (!said) std::this_thread::sleep_for(1ms);
  const auto begun = std::chrono::steady_clock::now();
  camera.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10s);
  EXPECT_EQ(token.use_count(), 1);
}

TEST(AbsentCamera, MayBeAskedForAnImpossibleSize) {
  const TemporaryFolder folder;
  CameraOptions options;
  options.device = folder / "video0";
  for (const int width : {0, -5, 321, 1'000'000}) {
    options.width = width;
    Camera camera{options};
    EXPECT_EQ(camera.newest().width, 320);
    EXPECT_EQ(camera.newest().height, 240);
  }
}

TEST(BlackPicture, IsBlackInEitherForm) {
  const Picture bgra = blackPicture({64, 48}, PictureForm::kBgra), yuyv = blackPicture({64, 48}, PictureForm::kYuyv);
  std::vector<std::uint8_t> converted(bgra.bgra.size());
  pixels::yuyvToBgraRotated({yuyv.asFrame().yuyv, 64, 48, 128}, converted);
  EXPECT_EQ(converted, bgra.bgra);
  EXPECT_TRUE(yuyv.bgra.empty());
  EXPECT_TRUE(bgra.yuyv.empty());
}

}  // namespace
}  // namespace darwinop::v4l2
