// Supported and unsupported picture sizes.
#include <linux/videodev2.h>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/quirks.hpp"

namespace darwinop::v4l2 {
namespace {

struct SizesTest : testing::TestWithParam<Size> {
  VirtualCamera device;
  LogCapture log;
};

CameraOptions ofSize(LogCapture& log, Size size) {
  CameraOptions options = fastOptions(log);
  options.width = size.width;
  options.height = size.height;
  return options;
}

TEST_P(SizesTest, IsUsedUnchanged) {
  device.paint(3, GetParam());
  Camera camera{ofSize(log, GetParam())};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, GetParam().width);
  EXPECT_EQ(frame.height, GetParam().height);
  EXPECT_EQ(wrongPixels(frame, 3), 0);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Table41, SizesTest,
                         testing::Values(Size{320, 240}, Size{640, 360}, Size{640, 400}, Size{640, 480}, Size{768, 480},
                                         Size{800, 600}),
                         [](const auto& tested) { return text(tested.param); });

using OtherSizesTest = SizesTest;

TEST_F(OtherSizesTest, FallBackToTheSmallSizeWithAMessage) {
  Camera camera{ofSize(log, {500, 400})};  // the driver would give 640x400
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 320);
  EXPECT_EQ(frame.height, 240);
  EXPECT_EQ(wrongPixels(frame, 1), 0);
  EXPECT_EQ(log.times("500x400: using 320x240"), 1);
  EXPECT_EQ(log.lines().size(), 1u);
}

/// A camera with a single size.
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
  const InForce in_force{*this};  // last member: destroyed first
};

TEST_F(OtherSizesTest, AreAcceptedWhenTheCameraHasNoOther) {
  OneSize quirk{{640, 480}};
  device.paint(4, {640, 480});
  Camera camera{ofSize(log, {800, 600})};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 640);
  EXPECT_EQ(frame.height, 480);
  EXPECT_EQ(wrongPixels(frame, 4), 0);
  EXPECT_EQ(log.times("800x600: using 640x480"), 1);
}

TEST_F(OtherSizesTest, AreRejectedWhenTheCameraComesBackWithThem) {
  OneSize quirk{{320, 240}};
  Camera camera{fastOptions(log)};
  waitForPicture(camera);
  quirk.width = 640;
  quirk.height = 480;
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(log.receives(messageOf(CameraError::kUnplugged)));
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(log.receives(messageOf(CameraError::kOtherSize, "640x480 instead of 320x240")));
  EXPECT_EQ(camera.newest().width, 320);
  quirk.width = 320;
  quirk.height = 240;
  EXPECT_TRUE(log.receives(messageOfReturn()));
}

}  // namespace
}  // namespace darwinop::v4l2
