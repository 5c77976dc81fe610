// Unusual drivers: older kernels, padded rows, few buffers.
#include <linux/videodev2.h>

#include <cerrno>
#include <cstring>
#include <functional>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/device.hpp"
#include "hal/camera_v4l2/monotonic.hpp"
#include "hal/camera_v4l2/quirks.hpp"

namespace darwinop::v4l2 {
namespace {

/// Changes the result of one ioctl.
class Changed final : public Quirk {
 public:
  using Change = std::function<int(int result, void* answer)>;  // returns the result; may set errno
  Changed(unsigned long request, Change change) : request_{request}, change_{std::move(change)} {}
  int call(int fd, unsigned long request, void* argument) override {
    const int result = next(fd, request, argument);
    return request == request_ ? change_(result, argument) : result;
  }

 private:
  unsigned long request_;
  Change change_;
  const InForce in_force_{*this};  // last member: destroyed first
};

struct OddDriver : testing::Test {
  void expectPresentTime() {
    const Nanos before = monotonicNow();
    Camera camera{fastOptions(log)};
    const CameraFrame frame = waitForPicture(camera);
    EXPECT_GT(frame.time, before);
    EXPECT_LT(frame.time, monotonicNow());
  }

  VirtualCamera device;
  LogCapture log;
};

int fails(int error) {
  errno = error;
  return -1;
}

TEST_F(OddDriver, OfLinux2_6_31KeepsTheBufferOfADamagedPicture) {
  std::atomic<int> calls{0}, errors{0};
  const Changed quirk{VIDIOC_DQBUF, [&](int result, void*) {
                        if (result != 0 || ++calls % 3 != 0) return result;
                        ++errors;
                        return fails(EIO);  // the buffer is neither queued nor dequeued
                      }};
  Camera camera{fastOptions(log)};
  ASSERT_TRUE(waitFor([&] { return errors >= 8; })) << "out of buffers";
  ASSERT_TRUE(waitForFrames(camera, 2));
  EXPECT_THAT(log.lines(), testing::IsEmpty());
  EXPECT_EQ(camera.health().reopened, 0u);
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(log.receives(messageOf(CameraError::kUnplugged)));
  const CameraHealth health = camera.health();
  EXPECT_GE(health.damaged, 8u);
  const std::uint64_t last = camera.newest().sequence, counted = health.frames + health.damaged + health.dropped;
  EXPECT_GE(counted, last);
  EXPECT_LE(counted, last + 1) << "a damaged picture is not dropped";  // the last one has no number yet
}

TEST_F(OddDriver, AnswersEveryReadWithAnErrorAtOnce) {
  struct : Quirk {
    int call(int fd, unsigned long request, void* argument) override {
      return request == VIDIOC_DQBUF ? fails(EIO)
                                     : next(fd, request, argument);  // the picture stays, so errors are immediate
    }
  } quirk;
  const InForce in_force{quirk};
  CameraOptions options = fastOptions(log);
  options.patience.silent = 60s;  // the error must be detected earlier
  Camera camera{options};
  ASSERT_TRUE(log.receives(messageOf(CameraError::kReadErrors, std::strerror(EIO))));
  EXPECT_EQ(camera.newest().sequence, 0u);
}

TEST_F(OddDriver, IsSlowerThanTheRobotsCamera) {
  const Changed quirk{VIDIOC_S_PARM, [](int result, void* answer) {
                        static_cast<v4l2_streamparm*>(answer)->parm.capture.timeperframe = {2, 15};
                        return result;
                      }};
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(log.receives("7.5 pictures/s at 320x240"));
}

TEST_F(OddDriver, DoesNotReportItsRate) {
  const Changed quirk{VIDIOC_S_PARM, [](int result, void* answer) {
                        static_cast<v4l2_streamparm*>(answer)->parm.capture.timeperframe = {0, 0};
                        return result;
                      }};
  Camera camera{fastOptions(log)};
  waitForPicture(camera);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(OddDriver, PadsItsRows) {
  // The device delivers 640x480, of which the upper left quarter is shown.
  struct Padded final : Quirk {
    int call(int fd, unsigned long request, void* argument) override {
      if (request != VIDIOC_S_FMT) return next(fd, request, argument);
      v4l2_pix_format& pixels = static_cast<v4l2_format*>(argument)->fmt.pix;
      pixels.width = 640;
      pixels.height = 480;
      const int result = next(fd, request, argument);
      pixels.width = 320;
      pixels.height = 240;
      pixels.bytesperline = 1280;
      return result;
    }
  } quirk;
  const InForce in_force{quirk};
  device.paint(5, {640, 480});
  Camera camera{fastOptions(log)};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 320);
  EXPECT_EQ(wrongPixels(frame, 5, 1280), 0);
}

TEST_F(OddDriver, LeavesTheRowLengthUnset) {
  const Changed quirk{VIDIOC_S_FMT, [](int result, void* answer) {
                        static_cast<v4l2_format*>(answer)->fmt.pix.bytesperline = 0;
                        return result;
                      }};
  Camera camera{fastOptions(log)};
  EXPECT_EQ(wrongPixels(waitForPicture(camera), 1), 0);
}

TEST_F(OddDriver, GrantsTwoBuffers) {
  struct Two final : Quirk {
    int call(int fd, unsigned long request, void* argument) override {
      if (request == VIDIOC_REQBUFS) static_cast<v4l2_requestbuffers*>(argument)->count = 2;
      return next(fd, request, argument);
    }
  } quirk;
  const InForce in_force{quirk};
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(waitForFrames(camera, 10));
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(OddDriver, UsesTimeOfDayTimestamps) {
  const Changed quirk{VIDIOC_DQBUF, [](int result, void* answer) {
                        auto& buffer = *static_cast<v4l2_buffer*>(answer);
                        buffer.flags &= ~static_cast<std::uint32_t>(V4L2_BUF_FLAG_TIMESTAMP_MASK);
                        buffer.timestamp.tv_sec = 1;
                        return result;
                      }};
  expectPresentTime();
}

TEST_F(OddDriver, MarksTheTimeOfDayAsMonotonic) {
  const Changed quirk{VIDIOC_DQBUF, [](int result, void* answer) {
                        static_cast<v4l2_buffer*>(answer)->timestamp.tv_sec = 2'000'000'000;
                        return result;
                      }};
  expectPresentTime();
}

TEST_F(OddDriver, TakesNoPictures) {
  const Changed quirk{VIDIOC_QUERYCAP, [](int result, void* answer) {
                        auto& able = *static_cast<v4l2_capability*>(answer);
                        able.device_caps &= ~static_cast<std::uint32_t>(V4L2_CAP_VIDEO_CAPTURE);
                        return result;
                      }};
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(log.receives(messageOf(CameraError::kNotACamera, kNoVideoCapture)));
}

TEST_F(OddDriver, ExceedsTheBusBandwidth) {
  const Changed quirk{VIDIOC_STREAMON, [](int, void*) { return fails(ENOSPC); }};
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(log.receives(messageOf(CameraError::kNoBandwidth)));
}

TEST_F(OddDriver, ReturnsABufferThatWasNotQueued) {
  const Changed quirk{VIDIOC_DQBUF, [](int result, void* answer) {
                        static_cast<v4l2_buffer*>(answer)->index = 4711;
                        return result;
                      }};
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(log.receives(messageOf(CameraError::kReadErrors, std::strerror(EPROTO))));
  EXPECT_EQ(camera.newest().sequence, 0u);
}

TEST_F(OddDriver, PollsReadyWithoutAPicture) {
  struct : Quirk {
    int call(int fd, unsigned long request, void* argument) override {
      if (request != VIDIOC_DQBUF) return next(fd, request, argument);
      ++calls;
      return fails(EAGAIN);
    }
    std::atomic<int> calls{0};
  } quirk;
  const InForce in_force{quirk};
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(log.receives(messageOf(CameraError::kSilent)));
  EXPECT_LT(quirk.calls, 1000) << "busy loop";
}

}  // namespace
}  // namespace darwinop::v4l2
