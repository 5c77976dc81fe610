// A camera that is lost and comes back, and one whose owner leaves.
#include <linux/videodev2.h>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/quirks.hpp"
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
  options.patience.grace = inAHurry(ears).patience.grace;
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
  const auto token = std::make_shared<int>(0);
  options.say = [token](const std::string&) {};
  auto camera = std::make_unique<Camera>(options);
  options.say = nullptr;
  waitForPicture(*camera);
  device.fault(CameraFault::kSilent);
  std::this_thread::sleep_for(50ms);
  const auto begun = std::chrono::steady_clock::now();
  camera.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10s);
  EXPECT_EQ(token.use_count(), 1) << "its thread was left behind";
}

/// A driver that does not return from its first call of one kind, until it is told.
struct StuckDriver final : Quirk {
  explicit StuckDriver(unsigned long where) : in{where} {}
  int call(int fd, unsigned long request, void* argument) override {
    if (request == in && !reached.exchange(true)) waitFor([this] { return !stuck; });
    return next(fd, request, argument);
  }
  const unsigned long in;
  std::atomic<bool> stuck{true}, reached{false};
  const InForce in_force{*this};  // the last member: the first to go
};

TEST_F(ComingAndGoing, DoesNotKeepItsOwnerWaitingForADriverThatIsStuck) {
  StuckDriver driver{VIDIOC_S_FMT};
  const auto token = std::make_shared<int>(0);
  std::atomic<int> said{0};
  CameraOptions options = inAHurry(ears);
  options.say = [token, &said](const std::string&) { ++said; };
  options.patience.grace = 100ms;
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
}

TEST_F(ComingAndGoing, DoesNotBlameOthersForAPredecessorThatIsStuck) {
  StuckDriver driver{VIDIOC_DQBUF};
  const auto token = std::make_shared<int>(0);
  CameraOptions options = inAHurry(ears);
  options.say = [token](const std::string&) {};
  options.patience.grace = 10ms;
  auto predecessor = std::make_unique<Camera>(options);
  options.say = nullptr;
  ASSERT_TRUE(waitFor([&] { return driver.reached.load(); }));
  predecessor.reset();
  ASSERT_NE(token.use_count(), 1) << "its thread is not left behind";
  Camera camera{inAHurry(ears)};
  std::this_thread::sleep_for(100ms);  // it is refused, several times
  EXPECT_EQ(camera.health().frames, 0u);
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
  driver.stuck = false;
  waitForPicture(camera);
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
}

TEST_F(ComingAndGoing, TellsWhenAPredecessorStaysStuck) {
  StuckDriver driver{VIDIOC_DQBUF};
  CameraOptions options = inAHurry(ears);
  options.patience.grace = 10ms;
  auto predecessor = std::make_unique<Camera>(options);
  ASSERT_TRUE(waitFor([&] { return driver.reached.load(); }));
  predecessor.reset();
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(ears.hears("is in use"));
  driver.stuck = false;
  EXPECT_TRUE(ears.hears("is back"));
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
