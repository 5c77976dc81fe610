// The camera's library in this very process: each fault, as a program sees it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "client.hpp"

namespace darwinop::hil {
namespace {

constexpr int kSomeFramesMs = 300;

/// Streams, then has the fault.
struct Faulty {
  explicit Faulty(CameraFault fault) {
    EXPECT_EQ(client.begin(320, 240), 0);
    EXPECT_EQ(client.frame(), 0);
    setFault(fault);
  }
  /// Frames from before may wait in all buffers: they are taken.
  void setFault(CameraFault fault) {
    eyes.painter.setFault(fault);
    for (unsigned i = 0; i < client.buffers.count; ++i)
      if (client.frame() != 0) break;
  }
  Eyes eyes;
  Client client;
};

TEST(CameraFault, GoneEndsTheDescriptorForGood) {
  Faulty camera{CameraFault::kGone};
  EXPECT_TRUE(camera.client.readable());
  EXPECT_EQ(camera.client.frame(), ENODEV);
  struct stat status = {};
  EXPECT_EQ(stat(kDevice, &status), -1);
  EXPECT_LT(Client{}.fd, 0);
  EXPECT_EQ(errno, ENOENT);
  camera.eyes.painter.setFault(CameraFault::kNone);
  EXPECT_EQ(camera.client.stream(), ENODEV);
  EXPECT_GE(Client{}.fd, 0);
}

TEST(CameraFault, SilentIsAQuietDescriptorUntilItIsOver) {
  Faulty camera{CameraFault::kSilent};
  EXPECT_FALSE(camera.client.readable(kSomeFramesMs));
  camera.eyes.painter.setFault(CameraFault::kNone);
  EXPECT_EQ(camera.client.frame(), 0);
}

TEST(CameraFault, ShortFramesAreHalf) {
  Faulty camera{CameraFault::kShort};
  ASSERT_EQ(camera.client.frame(), 0);
  EXPECT_EQ(camera.client.last.bytesused, 320u * 240);
}

TEST(CameraFault, FlaggedFramesSaySo) {
  Faulty camera{CameraFault::kFlagged};
  ASSERT_EQ(camera.client.frame(), 0);
  EXPECT_NE(camera.client.last.flags & V4L2_BUF_FLAG_ERROR, 0u);
  camera.setFault(CameraFault::kNone);
  ASSERT_EQ(camera.client.frame(), 0);
  EXPECT_EQ(camera.client.last.flags & V4L2_BUF_FLAG_ERROR, 0u);
}

TEST(CameraFault, IoErrorsGoOnUntilTheyAreOverAndCostNoBuffer) {
  Faulty camera{CameraFault::kIoError};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(camera.client.frame(), EIO);
  camera.eyes.painter.setFault(CameraFault::kNone);
  EXPECT_EQ(camera.client.frame(), 0);
}

TEST(CameraFault, SlowIsFiveFramesASecond) {
  Faulty camera{CameraFault::kSlow};
  ASSERT_EQ(camera.client.frame(), 0);
  const timeval before = camera.client.last.timestamp;
  ASSERT_EQ(camera.client.frame(), 0);
  const timeval& after = camera.client.last.timestamp;
  EXPECT_GT(
      static_cast<double>(after.tv_sec - before.tv_sec) + 1e-6 * static_cast<double>(after.tv_usec - before.tv_usec),
      0.1);
}

TEST(CameraFault, BusyRefusesFormatAndStreaming) {
  Eyes eyes;
  eyes.painter.setFault(CameraFault::kBusy);
  Client client;
  EXPECT_EQ(client.setSize(320, 240), EBUSY);
  ASSERT_EQ(client.requestBuffers(4), 0);
  ASSERT_EQ(client.mapAndQueue(), 0);
  EXPECT_EQ(client.stream(), EBUSY);
}

TEST(CameraFault, NoAccessIsThereButDoesNotOpen) {
  Eyes eyes;
  eyes.painter.setFault(CameraFault::kNoAccess);
  struct stat status = {};
  EXPECT_EQ(stat(kDevice, &status), 0);
  EXPECT_EQ(access(kDevice, R_OK), -1);
  EXPECT_LT(Client{}.fd, 0);
  EXPECT_EQ(errno, EACCES);
}

TEST(CameraFault, OtherFormatIsNotWhatWasAskedFor) {
  Eyes eyes;
  eyes.painter.setFault(CameraFault::kOtherFormat);
  Client client;
  ASSERT_EQ(client.setSize(320, 240), 0);
  EXPECT_EQ(client.format.fmt.pix.pixelformat, V4L2_PIX_FMT_MJPEG);
}

TEST(CameraFault, OneBufferIsAllThatThereIs) {
  Eyes eyes;
  eyes.painter.setFault(CameraFault::kOneBuffer);
  Client client;
  ASSERT_EQ(client.requestBuffers(4), 0);
  EXPECT_EQ(client.buffers.count, 1u);
}

TEST(CameraFault, NoMmapHasNoBuffersAndSaysSo) {
  Eyes eyes;
  eyes.painter.setFault(CameraFault::kNoMmap);
  Client client;
  v4l2_capability capability = {};
  ASSERT_EQ(client.ask(VIDIOC_QUERYCAP, capability), 0);
  EXPECT_EQ(capability.device_caps & V4L2_CAP_STREAMING, 0u);
  EXPECT_EQ(client.requestBuffers(4), EINVAL);
}

TEST(CameraFault, DropsLeaveGapsInTheNumbers) {
  Faulty camera{CameraFault::kDrops};
  for (int i = 0; i < 6; ++i) {
    ASSERT_EQ(camera.client.frame(), 0);
    EXPECT_NE(camera.client.last.sequence % 3, 2u);
  }
}

}  // namespace
}  // namespace darwinop::hil
