// The camera's library in this very process: a camera that works.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

#include "client.hpp"

namespace darwinop::hil {
namespace {

TEST(VirtualCamera, IsNotThereUntilItIsAskedFor) {
  unsetenv("DARWINOP_VIRTUAL_CAMERA");
  setenv("DARWINOP_VIRTUAL_CAMERA_DEVICE", "/dev/null", 1);
  const int fd = open("/dev/null", O_RDWR);
  v4l2_capability capability = {};
  EXPECT_EQ(ioctl(fd, VIDIOC_QUERYCAP, &capability), -1);
  EXPECT_EQ(errno, ENOTTY);
  close(fd);
  unsetenv("DARWINOP_VIRTUAL_CAMERA_DEVICE");
}

TEST(VirtualCamera, IsACharacterDeviceAndOtherFilesAreWhatTheyWere) {
  const Eyes eyes;
  struct stat status = {};
  ASSERT_EQ(stat(kDevice, &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
  EXPECT_EQ(status.st_rdev, makedev(81, 0));
  EXPECT_EQ(access(kDevice, R_OK | W_OK), 0);
  const int fd = open((eyes.folder / "new").c_str(), O_RDWR | O_CREAT, 0640);
  ASSERT_GE(fd, 0);
  ASSERT_EQ(fstat(fd, &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
  ASSERT_EQ(ftruncate(fd, 4096), 0);
  void* const memory = mmap(nullptr, 4096, PROT_READ, MAP_SHARED, fd, 0);
  EXPECT_NE(memory, MAP_FAILED);
  munmap(memory, 4096);
  EXPECT_EQ(close(fd), 0);
  EXPECT_EQ(close(fd), -1);
}

TEST(VirtualCamera, AnswersAnUnknownSizeWithTheNearest) {
  const Eyes eyes;
  Client client;
  ASSERT_EQ(client.setSize(160, 120), 0);
  EXPECT_EQ(client.format.fmt.pix.width, 320u);
  ASSERT_EQ(client.setSize(768, 480), 0);
  EXPECT_EQ(client.format.fmt.pix.width, 768u);
  EXPECT_EQ(client.format.fmt.pix.sizeimage, 768u * 480 * 2);
  EXPECT_EQ(eyes.painter.wanted(), (PictureSize{768, 480}));
  v4l2_streamparm parameters = {};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  ASSERT_EQ(client.ask(VIDIOC_G_PARM, parameters), 0);
  EXPECT_EQ(parameters.parm.capture.timeperframe.denominator, 28u);
}

TEST(VirtualCamera, IsGreyUntilSomebodyPaintsThatSizeThenShowsIt) {
  Eyes eyes;
  Client client;
  ASSERT_EQ(client.begin(320, 240), 0);
  ASSERT_EQ(client.frame(), 0);
  EXPECT_EQ(client.pixels()[0], 128);
  EXPECT_EQ(client.last.bytesused, 320u * 240 * 2);
  eyes.painter.paintYuyv({320, 240}, std::vector<std::uint8_t>(std::size_t{2} * 320 * 240, 77));
  for (int i = 0; i < 8 && client.pixels()[0] != 77; ++i) ASSERT_EQ(client.frame(), 0);
  EXPECT_EQ(client.pixels()[0], 77);
  EXPECT_EQ(client.pixels()[2 * 320 * 240 - 1], 77);
}

TEST(VirtualCamera, NumbersFramesAndSaysWhenTheyWereTaken) {
  const Eyes eyes;
  Client client;
  ASSERT_EQ(client.begin(320, 240), 0);
  ASSERT_EQ(client.frame(), 0);
  EXPECT_EQ(client.last.sequence, 0u);
  EXPECT_NE(client.last.flags & V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC, 0u);
  v4l2_buffer before = client.last;
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(client.frame(), 0);
    EXPECT_GT(client.last.sequence, before.sequence);
    EXPECT_TRUE(timercmp(&client.last.timestamp, &before.timestamp, >));
    before = client.last;
  }
}

TEST(VirtualCamera, LosesAndCountsFramesForWhichThereIsNoBuffer) {
  const Eyes eyes;
  Client client;
  ASSERT_EQ(client.begin(320, 240, 1), 0);
  ASSERT_EQ(client.frame(), 0);
  EXPECT_EQ(client.last.sequence, 0u);
  unsigned taken = 1;
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds{20};
  do {
    // The camera's time, not ours to inject: most likely the only buffer is full when the next frame comes.
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    ASSERT_EQ(client.frame(), 0);
    ++taken;
  } while (client.last.sequence < taken && std::chrono::steady_clock::now() < limit);
  EXPECT_GE(client.last.sequence, taken) << "none was lost, or it was not counted";
}

TEST(VirtualCamera, StartsAgainWithFrameZero) {
  const Eyes eyes;
  Client client;
  ASSERT_EQ(client.begin(320, 240), 0);
  ASSERT_EQ(client.frame(), 0);
  ASSERT_EQ(client.stream(VIDIOC_STREAMOFF), 0);
  EXPECT_FALSE(client.readable(0));
  for (unsigned i = 0; i < client.buffers.count; ++i) {
    v4l2_buffer one = Client::buffer(i);
    ASSERT_EQ(client.ask(VIDIOC_QBUF, one), 0);
  }
  ASSERT_EQ(client.stream(), 0);
  ASSERT_EQ(client.frame(), 0);
  EXPECT_EQ(client.last.sequence, 0u);
}

TEST(VirtualCamera, BelongsToWhoeverHasItsBuffers) {
  const Eyes eyes;
  Client first, second;
  ASSERT_EQ(first.begin(320, 240), 0);
  EXPECT_EQ(second.requestBuffers(4), EBUSY);
  EXPECT_EQ(second.setSize(640, 480), EBUSY);
  EXPECT_EQ(first.frame(), 0);
}

TEST(VirtualCamera, RefusesAnExposureWhileThatIsAutomatic) {
  const Eyes eyes;
  const Client client;
  ASSERT_EQ(client.control(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY), 0);
  EXPECT_EQ(client.control(V4L2_CID_EXPOSURE_ABSOLUTE, 1000), EACCES);
  EXPECT_EQ(client.control(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_AUTO), EINVAL);
  ASSERT_EQ(client.control(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL), 0);
  EXPECT_EQ(client.control(V4L2_CID_EXPOSURE_ABSOLUTE, 1000), 0);
  EXPECT_EQ(client.control(V4L2_CID_PAN_ABSOLUTE, 0), EINVAL);
  ASSERT_EQ(client.control(V4L2_CID_GAIN, 999), 0);
  v4l2_control gain = {V4L2_CID_GAIN, 0};
  ASSERT_EQ(client.ask(VIDIOC_G_CTRL, gain), 0);
  EXPECT_EQ(gain.value, 255);
}

TEST(VirtualCamera, EndsAWaitWhenAnotherThreadSwitchesItOff) {
  const Eyes eyes;
  Client client{O_RDWR};
  ASSERT_EQ(client.setSize(320, 240), 0);
  ASSERT_EQ(client.requestBuffers(1), 0);
  ASSERT_EQ(client.stream(), 0);  // no buffer is queued: nothing ever comes
  int error = 0;
  std::thread waits{[&] {
    v4l2_buffer one = Client::buffer();
    error = client.ask(VIDIOC_DQBUF, one);
  }};
  std::this_thread::sleep_for(std::chrono::milliseconds{100});  // so that it does wait
  EXPECT_EQ(client.stream(VIDIOC_STREAMOFF), 0);
  waits.join();
  EXPECT_EQ(error, EINVAL);
}

TEST(VirtualCamera, IsNotInheritedByAChildWhichMayCloseEverythingAndOpenItsOwn) {
  const Eyes eyes;
  Client client;
  ASSERT_EQ(client.begin(320, 240), 0);
  const pid_t child = fork();
  if (child == 0) {
    alarm(5);
    v4l2_capability capability = {};
    if (client.ask(VIDIOC_QUERYCAP, capability) != ENOTTY) _exit(1);
    for (int fd = 3; fd < 64; ++fd) close(fd);
    const Client its_own;
    if (its_own.fd < 0 || its_own.ask(VIDIOC_QUERYCAP, capability) != 0) _exit(2);
    v4l2_requestbuffers buffers = {4, V4L2_BUF_TYPE_VIDEO_CAPTURE, V4L2_MEMORY_MMAP, 0, 0, {}};
    _exit(its_own.ask(VIDIOC_REQBUFS, buffers) == 0 ? 0 : 3);  // EBUSY while they are its parent's
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(client.frame(), 0);
}

}  // namespace
}  // namespace darwinop::hil
