// Pictures of a working camera.
#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/monotonic.hpp"

namespace darwinop::v4l2 {
namespace {

struct PicturesTest : testing::Test {
  VirtualCamera device;
  LogCapture log;
};

TEST_F(PicturesTest, AreRotatedAndBitExact) {
  Camera camera{fastOptions(log)};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 320);
  EXPECT_EQ(frame.height, 240);
  ASSERT_EQ(frame.bgra.size(), 4u * 320 * 240);
  EXPECT_EQ(wrongPixels(frame, 1), 0);
  EXPECT_NE(wrongPixels(frame, 2), 0);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(PicturesTest, AreInCameraFormatOnRequest) {
  CameraOptions options = fastOptions(log);
  options.form = PictureForm::kYuyv;
  Camera camera{options};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_TRUE(frame.bgra.empty());
  ASSERT_EQ(frame.yuyv.size(), 2u * 320 * 240);
  for (std::size_t i = 0; i < frame.yuyv.size(); ++i) ASSERT_EQ(frame.yuyv[i], noise(1, i)) << i;
}

TEST_F(PicturesTest, StayUnchangedUntilTheNextCall) {
  Camera camera{fastOptions(log)};
  const CameraFrame frame = waitForPicture(camera);
  device.paint(2, kFallback);
  ASSERT_TRUE(waitForFrames(camera, 5));
  EXPECT_EQ(wrongPixels(frame, 1), 0);
  EXPECT_EQ(wrongPixels(camera.newest(), 2), 0);
}

TEST_F(PicturesTest, StayTheSameUntilThereIsANewerOne) {
  Camera camera{fastOptions(log)};
  waitForPicture(camera);
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(log.receives(messageOf(CameraError::kUnplugged)));
  const CameraFrame last = camera.newest(), again = camera.newest();
  EXPECT_EQ(last.sequence, again.sequence);
  EXPECT_EQ(last.time, again.time);
  EXPECT_EQ(last.bgra.data(), again.bgra.data());
  EXPECT_EQ(wrongPixels(again, 1), 0);
}

TEST_F(PicturesTest, HaveTheirCaptureTime) {
  const auto before = monotonicNow();
  Camera camera{fastOptions(log)};
  const CameraFrame first = waitForPicture(camera);
  const Nanos first_time = first.time;
  const CameraFrame second = waitForPicture(camera, first.sequence);
  EXPECT_GT(first_time, before);
  EXPECT_GT(second.time, first_time);
  EXPECT_LT(second.time, monotonicNow());
}

TEST_F(PicturesTest, SetSeeing) {
  Camera camera{fastOptions(log)};
  EXPECT_FALSE(camera.health().seeing);
  waitForPicture(camera);
  EXPECT_TRUE(camera.health().seeing);
}

}  // namespace
}  // namespace darwinop::v4l2
