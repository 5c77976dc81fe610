// A camera that is lost and comes back, and one whose owner leaves.
#include <linux/videodev2.h>

#include "hal_camera_v4l2/bench.hpp"
#include "hal_camera_v4l2/quirks.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::v4l2 {
namespace {

struct ComingAndGoing : testing::Test {
  VirtualCamera device;
  Ears ears;
};

TEST_F(ComingAndGoing, SaysEachOnceAndLeavesAGapInTheNumbers) {
  Camera camera{inAHurry(ears)};
  waitForPicture(camera);
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(ears.hears("the camera at /dev/video0 is gone: check its USB cable"));
  const std::uint64_t last = camera.newest().sequence;
  std::this_thread::sleep_for(100ms);  // several attempts
  EXPECT_EQ(ears.heard().size(), 1u);
  EXPECT_EQ(camera.newest().sequence, last);

  device.paint(2, kFallback);
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(ears.hears("the camera at /dev/video0 is back"));
  const CameraFrame frame = waitForPicture(camera, last);
  EXPECT_GE(frame.sequence, last + 2);
  EXPECT_EQ(wrongPixels(frame, 2), 0);
  EXPECT_EQ(camera.health().reopened, 1u);
  EXPECT_TRUE(camera.health().seeing);
  EXPECT_EQ(ears.heard().size(), 2u);

  device.fault(CameraFault::kGone);
  EXPECT_TRUE(waitFor([&] { return ears.times("is gone") == 2; })) << "said anew after it was back";
}

TEST_F(ComingAndGoing, CountsAllPictures) {
  Camera camera{inAHurry(ears)};
  ASSERT_TRUE(waitForFrames(camera, 2));
  device.fault(CameraFault::kDrops);
  const std::uint64_t dropped = camera.health().dropped;
  ASSERT_TRUE(waitFor([&] { return camera.health().dropped >= dropped + 2; }));
  device.fault(CameraFault::kFlagged);
  ASSERT_TRUE(waitFor([&] { return camera.health().damaged >= 2; }));
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(waitForFrames(camera, 2));
  device.fault(CameraFault::kSilent);
  ASSERT_TRUE(waitFor([&] { return camera.health().reopened == 1; }));
  const CameraHealth health = camera.health();
  EXPECT_EQ(health.frames + health.dropped + health.damaged, camera.newest().sequence);
}

TEST_F(ComingAndGoing, IsSeenForTwoSecondsAfterTheLastPicture) {
  CameraOptions options = inAHurry(ears);
  options.patience = {};  // as on the robot
  Camera camera{options};
  waitForPicture(camera);
  device.fault(CameraFault::kSilent);
  const auto begun = std::chrono::steady_clock::now();
  ASSERT_TRUE(ears.hears("sends no pictures"));
  EXPECT_GT(std::chrono::steady_clock::now() - begun, 1500ms);
  EXPECT_FALSE(camera.health().seeing);
  device.fault(CameraFault::kNone);
  EXPECT_TRUE(ears.hears("is back"));
  EXPECT_TRUE(camera.health().seeing);
}

TEST_F(ComingAndGoing, DoesNotKeepItsOwnerWaitingForASilentCamera) {
  CameraOptions options = inAHurry(ears);
  options.patience.silent = 60s;
  auto camera = std::make_unique<Camera>(options);
  waitForPicture(*camera);
  device.fault(CameraFault::kSilent);
  std::this_thread::sleep_for(50ms);
  const auto begun = std::chrono::steady_clock::now();
  camera.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10s);
}

/// A driver that does not return.
struct StuckDriver final : Quirk {
  int call(int fd, unsigned long request, void* argument) override {
    if (request == VIDIOC_S_FMT)
      while (stuck) {
        reached = true;
        std::this_thread::sleep_for(1ms);
      }
    return next(fd, request, argument);
  }
  std::atomic<bool> stuck{true}, reached{false};
};

TEST_F(ComingAndGoing, DoesNotKeepItsOwnerWaitingForADriverThatIsStuck) {
  StuckDriver driver;
  const auto token = std::make_shared<int>(0);
  std::atomic<int> said{0};
  CameraOptions options = inAHurry(ears);
  options.say = [token, &said](const std::string&) { ++said; };
  auto camera = std::make_unique<Camera>(options);
  options.say = nullptr;
  ASSERT_TRUE(waitFor([&] { return driver.reached.load(); }));
  const auto begun = std::chrono::steady_clock::now();
  camera.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10s);
  EXPECT_TRUE(driver.stuck);
  device.fault(CameraFault::kGone);  // something to say, to nobody
  driver.stuck = false;
  EXPECT_TRUE(waitFor([&] { return token.use_count() == 1; })) << "the thread still holds its listener";
  EXPECT_EQ(said, 0);
  std::this_thread::sleep_for(50ms);  // it leaves the driver
}

TEST_F(ComingAndGoing, TakesNothingFromTheHeapPerPicture) {
  std::vector<long> allocations;  // of the camera's thread, each time it says something
  std::mutex mutex;
  CameraOptions options = inAHurry(ears);
  options.say = [&](const std::string&) {
    const std::lock_guard lock{mutex};
    allocations.push_back(allocationsOfThisThread());
  };
  const auto said = [&] {
    const std::lock_guard lock{mutex};
    return allocations.size();
  };
  Camera camera{options};
  // "is back", pictures, "is gone": what is allocated between the two are the words, however many pictures came.
  const auto comes_and_goes = [&](std::uint64_t pictures) {
    const std::size_t before = said();
    device.fault(CameraFault::kNone);
    EXPECT_TRUE(waitFor([&] { return said() == before + 1; }));
    EXPECT_TRUE(waitForFrames(camera, pictures));
    device.fault(CameraFault::kGone);
    EXPECT_TRUE(waitFor([&] { return said() == before + 2; }));
    const std::lock_guard lock{mutex};
    return allocations[before + 1] - allocations[before];
  };
  ASSERT_TRUE(waitForFrames(camera, 1));
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(waitFor([&] { return said() == 1; }));
  comes_and_goes(1);  // this vector grows
  comes_and_goes(1);
  {
    const std::lock_guard lock{mutex};
    allocations.reserve(100);
  }
  const long few = comes_and_goes(2);
  EXPECT_EQ(comes_and_goes(20), few);
}

}  // namespace
}  // namespace darwinop::v4l2
