// The sizes of the robot's camera, and sizes that it does not have.
#include <linux/videodev2.h>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/quirks.hpp"

namespace darwinop::v4l2 {
namespace {

struct SizesTest : testing::TestWithParam<Size> {
  VirtualCamera device;
  Ears ears;
};

CameraOptions ofSize(Ears& ears, Size size) {
  CameraOptions options = inAHurry(ears);
  options.width = size.width;
  options.height = size.height;
  return options;
}

TEST_P(SizesTest, IsTakenAsItIs) {
  device.paint(3, GetParam());
  Camera camera{ofSize(ears, GetParam())};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, GetParam().width);
  EXPECT_EQ(frame.height, GetParam().height);
  EXPECT_EQ(wrongPixels(frame, 3), 0);
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Table41, SizesTest,
                         testing::Values(Size{320, 240}, Size{640, 360}, Size{640, 400}, Size{640, 480}, Size{768, 480},
                                         Size{800, 600}),
                         [](const auto& tested) { return text(tested.param); });

using OtherSizesTest = SizesTest;

TEST_F(OtherSizesTest, BecomeTheSmallOneWithAMessage) {
  Camera camera{ofSize(ears, {500, 400})};  // the driver would give 640x400
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 320);
  EXPECT_EQ(frame.height, 240);
  EXPECT_EQ(wrongPixels(frame, 1), 0);
  EXPECT_EQ(ears.times("/dev/video0 gives no pictures of 500x400: they are 320x240 now"), 1);
  EXPECT_EQ(ears.heard().size(), 1u);
}

/// A camera that has one size only.
struct OneSize final : Quirk {
  explicit OneSize(Size has) : width(has.width), height(has.height) {}
  int call(int fd, unsigned long request, void* argument) override {
    if (request == VIDIOC_S_FMT) {
      v4l2_pix_format& pixels = static_cast<v4l2_format*>(argument)->fmt.pix;
      pixels.width = static_cast<std::uint32_t>(width.load());
      pixels.height = static_cast<std::uint32_t>(height.load());
    }
    return next(fd, request, argument);
  }
  std::atomic<int> width, height;
  const InForce in_force{*this};  // the last member: the first to go
};

TEST_F(OtherSizesTest, AreTakenWhenTheCameraHasNothingElse) {
  OneSize quirk{{640, 480}};
  device.paint(4, {640, 480});
  Camera camera{ofSize(ears, {800, 600})};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 640);
  EXPECT_EQ(frame.height, 480);
  EXPECT_EQ(wrongPixels(frame, 4), 0);
  EXPECT_EQ(ears.times("/dev/video0 gives no pictures of 800x600: they are 640x480 now"), 1);
}

TEST_F(OtherSizesTest, AreNotTakenWhenTheCameraComesBackWithThem) {
  OneSize quirk{{320, 240}};
  Camera camera{inAHurry(ears)};
  waitForPicture(camera);
  quirk.width = 640;
  quirk.height = 480;
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(ears.hears("is gone"));
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(ears.hears("now gives pictures of 640x480 instead of 320x240"));
  EXPECT_EQ(camera.newest().width, 320);
  quirk.width = 320;
  quirk.height = 240;
  EXPECT_TRUE(ears.hears("is back"));
}

}  // namespace
}  // namespace darwinop::v4l2
