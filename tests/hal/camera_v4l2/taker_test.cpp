// PictureTaker without a thread.
#include <linux/videodev2.h>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/camera_error.hpp"
#include "hal/camera_v4l2/picture_taker.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::v4l2 {
namespace {

struct TakerTest : testing::Test {
  VirtualCamera camera;
  V4l2Device device{"/dev/video0"};
  PictureShape shape = negotiate(device, kFallback, [](const std::string&) {});
  StreamBuffers buffers{device};
  TripleBuffer<Picture> pictures{blackPicture(shape.size, PictureForm::kBgra)};
  FrameCount count;
  Counters counters;
  std::uint64_t raw = 0;
  RawFrameTaker on_raw_frame = [this](const pixels::YuyvImage& image, std::uint64_t sequence, Nanos /*time*/) {
    if (isWhole(image)) raw = sequence;
  };
  PictureTaker taker{buffers, shape, pictures, count, counters, on_raw_frame};

  [[nodiscard]] std::uint32_t filled() const {
    std::uint32_t done = 0;
    for (std::uint32_t i = 0; i < buffers.count(); ++i) {
      v4l2_buffer buffer{};
      buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
      buffer.index = i;
      EXPECT_EQ(request(device.fd(), VIDIOC_QUERYBUF, buffer), 0);
      if ((buffer.flags & V4L2_BUF_FLAG_DONE) != 0) ++done;
    }
    return done;
  }
  bool waitForFilled(std::uint32_t many) {
    return waitFor([&] { return filled() >= many; });
  }
};

TEST_F(TakerTest, ShowsTheNewestReadyPicture) {
  ASSERT_TRUE(waitForFilled(buffers.count()));
  const PictureTaker::Outcome outcome = taker.takeAll();
  EXPECT_TRUE(outcome.shown);
  EXPECT_EQ(outcome.error, 0);
  ASSERT_TRUE(pictures.update());
  EXPECT_EQ(pictures.front().sequence, buffers.count());
  EXPECT_EQ(raw, buffers.count()) << "the same picture in camera format";
  EXPECT_EQ(counters.frames, buffers.count()) << "pictures that were not shown are counted";
  EXPECT_EQ(counters.dropped, 0u);
}

TEST_F(TakerTest, QueuesAllBuffersAgainAndCountsLostPictures) {
  unsigned rounds = 0;
  EXPECT_TRUE(waitFor([&] {
    if (!waitForFilled(buffers.count())) return false;
    std::this_thread::sleep_for(40ms);  // the camera has probably dropped a picture meanwhile
    ++rounds;
    return taker.takeAll().shown && counters.dropped > 0;
  }));
  EXPECT_EQ(counters.frames, rounds * buffers.count());
  pictures.update();
  EXPECT_EQ(pictures.front().sequence, counters.frames + counters.dropped);
}

TEST_F(TakerTest, IsIdleWhenNothingIsReady) {
  camera.fault(CameraFault::kSilent);
  EXPECT_TRUE(waitFor([&] { return taker.takeAll().idle; }));
  pictures.update();
  const PictureTaker::Outcome outcome = taker.takeAll();
  EXPECT_TRUE(outcome.idle);
  EXPECT_FALSE(outcome.shown);
  EXPECT_FALSE(pictures.update());
}

TEST_F(TakerTest, ShowsACompletePictureFollowedByABrokenOne) {
  // Retries: a late thread may see only complete pictures, or a broken one of the last attempt first.
  EXPECT_TRUE(waitFor([&] {
    camera.fault(CameraFault::kNone);
    if (!waitFor([&] { return taker.takeAll().idle; })) return false;
    if (!waitForFilled(1)) return false;
    camera.fault(CameraFault::kShort);
    if (!waitForFilled(buffers.count())) return false;
    const std::uint64_t damaged = counters.damaged;
    return taker.takeAll().shown && counters.damaged > damaged && pictures.update() &&
           wrongPixels(pictures.front().asFrame(), 1) == 0;
  }));
}

TEST_F(TakerTest, TakesNothingFromTheHeap) {
  const auto take_some = [this] {
    const std::uint64_t goal = counters.frames + 3;
    EXPECT_TRUE(waitFor([&] { return taker.takeAll(), counters.frames >= goal; }));
  };
  take_some();
  const long before = allocationsOfThisThread();
  take_some();
  EXPECT_EQ(allocationsOfThisThread(), before);
}

}  // namespace
}  // namespace darwinop::v4l2
