// What a controller sees of a camera that works.
#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/monotonic.hpp"

namespace darwinop::v4l2 {
namespace {

struct PicturesTest : testing::Test {
  VirtualCamera device;
  Ears ears;
};

TEST_F(PicturesTest, AreTurnedAndExactToTheLastBit) {
  Camera camera{inAHurry(ears)};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 320);
  EXPECT_EQ(frame.height, 240);
  ASSERT_EQ(frame.bgra.size(), 4u * 320 * 240);
  EXPECT_EQ(wrongPixels(frame, 1), 0);
  EXPECT_NE(wrongPixels(frame, 2), 0);
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
}

TEST_F(PicturesTest, AreAsTheCameraGaveThemWhenAskedFor) {
  CameraOptions options = inAHurry(ears);
  options.form = PictureForm::kYuyv;
  Camera camera{options};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_TRUE(frame.bgra.empty());
  ASSERT_EQ(frame.yuyv.size(), 2u * 320 * 240);
  for (std::size_t i = 0; i < frame.yuyv.size(); ++i) ASSERT_EQ(frame.yuyv[i], noise(1, i)) << i;
}

TEST_F(PicturesTest, StayAsTheyAreUntilTheNextOneIsAskedFor) {
  Camera camera{inAHurry(ears)};
  const CameraFrame frame = waitForPicture(camera);
  device.paint(2, kFallback);
  ASSERT_TRUE(waitForFrames(camera, 5));
  EXPECT_EQ(wrongPixels(frame, 1), 0);
  EXPECT_EQ(wrongPixels(camera.newest(), 2), 0);
}

TEST_F(PicturesTest, AreTheSameOnesWhileNothingNewerIsThere) {
  Camera camera{inAHurry(ears)};
  waitForPicture(camera);
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(ears.hears("is gone"));
  const CameraFrame last = camera.newest(), again = camera.newest();
  EXPECT_EQ(last.sequence, again.sequence);
  EXPECT_EQ(last.time, again.time);
  EXPECT_EQ(last.bgra.data(), again.bgra.data());
  EXPECT_EQ(wrongPixels(again, 1), 0);
}

TEST_F(PicturesTest, CarryTheTimeWhenTheyWereTaken) {
  const auto before = monotonicNow();
  Camera camera{inAHurry(ears)};
  const CameraFrame first = waitForPicture(camera);
  const Nanos first_time = first.time;
  const CameraFrame second = waitForPicture(camera, first.sequence);
  EXPECT_GT(first_time, before);
  EXPECT_GT(second.time, first_time);
  EXPECT_LT(second.time, monotonicNow());
}

TEST_F(PicturesTest, AreToldAsSeen) {
  Camera camera{inAHurry(ears)};
  EXPECT_FALSE(camera.health().seeing);
  waitForPicture(camera);
  EXPECT_TRUE(camera.health().seeing);
}

}  // namespace
}  // namespace darwinop::v4l2
