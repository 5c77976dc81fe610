// Drivers of another kind: older ones, padded rows, few buffers.
#include <linux/videodev2.h>

#include <cerrno>
#include <functional>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/monotonic.hpp"
#include "hal/camera_v4l2/quirks.hpp"

namespace darwinop::v4l2 {
namespace {

/// Changes the answers of one call.
class Changed final : public Quirk {
 public:
  using Change = std::function<int(int result, void* answer)>;  // gives the result; errno is its own
  Changed(unsigned long request, Change change) : request_{request}, change_{std::move(change)} {}
  int call(int fd, unsigned long request, void* argument) override {
    const int result = next(fd, request, argument);
    return request == request_ ? change_(result, argument) : result;
  }

 private:
  unsigned long request_;
  Change change_;
  const InForce in_force_{*this};  // the last member: the first to go
};

struct OddDriver : testing::Test {
  VirtualCamera device;
  Ears ears;
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
                        return fails(EIO);  // the buffer is neither the driver's nor, to its knowledge, ours
                      }};
  Camera camera{inAHurry(ears)};
  ASSERT_TRUE(waitFor([&] { return errors >= 8; })) << "it ran out of buffers";
  ASSERT_TRUE(waitForFrames(camera, 2));
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
  EXPECT_EQ(camera.health().reopened, 0u);
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(ears.hears("is gone"));
  const CameraHealth health = camera.health();
  EXPECT_GE(health.damaged, 8u);
  const std::uint64_t last = camera.newest().sequence, counted = health.frames + health.damaged + health.dropped;
  EXPECT_GE(counted, last);
  EXPECT_LE(counted, last + 1) << "a damaged picture is not a dropped one, too";  // the last one has no number yet
}

TEST_F(OddDriver, AnswersEveryReadWithAnErrorAtOnce) {
  struct : Quirk {
    int call(int fd, unsigned long request, void* argument) override {
      return request == VIDIOC_DQBUF ? fails(EIO) : next(fd, request, argument);  // the picture stays: no pace
    }
  } quirk;
  const InForce in_force{quirk};
  CameraOptions options = inAHurry(ears);
  options.patience.silent = 60s;  // it is noticed before that
  Camera camera{options};
  ASSERT_TRUE(ears.hears("cannot be read (Input/output error)"));
  EXPECT_EQ(camera.newest().sequence, 0u);
}

TEST_F(OddDriver, IsSlowerThanTheRobotsCamera) {
  const Changed quirk{VIDIOC_S_PARM, [](int result, void* answer) {
                        static_cast<v4l2_streamparm*>(answer)->parm.capture.timeperframe = {2, 15};
                        return result;
                      }};
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(ears.hears("/dev/video0 gives 7.5 pictures a second of 320x240, the robot's own camera 30.0: "));
}

TEST_F(OddDriver, DoesNotTellItsRate) {
  const Changed quirk{VIDIOC_S_PARM, [](int result, void* answer) {
                        static_cast<v4l2_streamparm*>(answer)->parm.capture.timeperframe = {0, 0};
                        return result;
                      }};
  Camera camera{inAHurry(ears)};
  waitForPicture(camera);
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
}

TEST_F(OddDriver, PadsItsRows) {
  // In truth 640x480, of which it shows the upper left quarter.
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
  Camera camera{inAHurry(ears)};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_EQ(frame.width, 320);
  EXPECT_EQ(wrongPixels(frame, 5, 1280), 0);
}

TEST_F(OddDriver, LeavesTheLengthOfARowOpen) {
  const Changed quirk{VIDIOC_S_FMT, [](int result, void* answer) {
                        static_cast<v4l2_format*>(answer)->fmt.pix.bytesperline = 0;
                        return result;
                      }};
  Camera camera{inAHurry(ears)};
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
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(waitForFrames(camera, 10));
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
}

TEST_F(OddDriver, StampsWithTheTimeOfDay) {
  const Changed quirk{VIDIOC_DQBUF, [](int result, void* answer) {
                        auto& buffer = *static_cast<v4l2_buffer*>(answer);
                        buffer.flags &= ~static_cast<std::uint32_t>(V4L2_BUF_FLAG_TIMESTAMP_MASK);
                        buffer.timestamp.tv_sec = 1;
                        return result;
                      }};
  const Nanos before = monotonicNow();
  Camera camera{inAHurry(ears)};
  const CameraFrame frame = waitForPicture(camera);
  EXPECT_GT(frame.time, before);
  EXPECT_LT(frame.time, monotonicNow());
}

TEST_F(OddDriver, TakesNoPictures) {
  const Changed quirk{VIDIOC_QUERYCAP, [](int result, void* answer) {
                        auto& able = *static_cast<v4l2_capability*>(answer);
                        able.device_caps &= ~static_cast<std::uint32_t>(V4L2_CAP_VIDEO_CAPTURE);
                        return result;
                      }};
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(ears.hears("/dev/video0 is not a camera that takes pictures (it takes no pictures)"));
}

TEST_F(OddDriver, HasNoRoomOnItsBus) {
  const Changed quirk{VIDIOC_STREAMON, [](int, void*) { return fails(ENOSPC); }};
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(ears.hears("the USB bus has no room for the pictures of /dev/video0"));
}

TEST_F(OddDriver, HandsOverABufferThatItWasNeverGiven) {
  const Changed quirk{VIDIOC_DQBUF, [](int result, void* answer) {
                        static_cast<v4l2_buffer*>(answer)->index = 4711;
                        return result;
                      }};
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(ears.hears("cannot be read (Protocol error)"));
  EXPECT_EQ(camera.newest().sequence, 0u);
}

TEST_F(OddDriver, SaysReadyAndHasNothing) {
  struct : Quirk {
    int call(int fd, unsigned long request, void* argument) override {
      if (request != VIDIOC_DQBUF) return next(fd, request, argument);
      ++calls;
      return fails(EAGAIN);
    }
    std::atomic<int> calls{0};
  } quirk;
  const InForce in_force{quirk};
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(ears.hears("sends no pictures"));
  EXPECT_LT(quirk.calls, 1000) << "it keeps a CPU busy";
}

}  // namespace
}  // namespace darwinop::v4l2
