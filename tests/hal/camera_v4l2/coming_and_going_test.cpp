// A camera that is lost and comes back, and owners that are destroyed early.
#include <linux/videodev2.h>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/quirks.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::v4l2 {
namespace {

struct ComingAndGoing : testing::Test {
  VirtualCamera device;
  LogCapture log;
};

TEST_F(ComingAndGoing, ReportsEachEventOnceAndLeavesASequenceGap) {
  Camera camera{fastOptions(log)};
  waitForPicture(camera);
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(log.receives(messageOf(CameraError::kUnplugged)));
  const std::uint64_t last = camera.newest().sequence;
  std::this_thread::sleep_for(100ms);  // several attempts
  EXPECT_EQ(log.lines().size(), 1u);
  EXPECT_EQ(camera.newest().sequence, last);

  device.paint(2, kFallback);
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(log.receives(messageOfReturn()));
  const CameraFrame frame = waitForPicture(camera, last);
  EXPECT_GE(frame.sequence, last + 2);
  EXPECT_EQ(wrongPixels(frame, 2), 0);
  EXPECT_EQ(camera.health().reopened, 1u);
  EXPECT_TRUE(camera.health().seeing);
  EXPECT_EQ(log.lines().size(), 2u);

  device.fault(CameraFault::kGone);
  EXPECT_TRUE(waitFor([&] { return log.times(messageOf(CameraError::kUnplugged)) == 2; }))
      << "reported again after recovery";
}

TEST_F(ComingAndGoing, CountsAllPictures) {
  Camera camera{fastOptions(log)};
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

TEST_F(ComingAndGoing, CountsAsSeeingForTwoSecondsAfterTheLastPicture) {
  CameraOptions options = fastOptions(log);
  options.patience = {};  // the robot's defaults
  options.patience.grace = fastOptions(log).patience.grace;
  Camera camera{options};
  waitForPicture(camera);
  device.fault(CameraFault::kSilent);
  const auto begun = std::chrono::steady_clock::now();
  ASSERT_TRUE(log.receives(messageOf(CameraError::kSilent)));
  EXPECT_GT(std::chrono::steady_clock::now() - begun, 1500ms);
  EXPECT_FALSE(camera.health().seeing);
  device.fault(CameraFault::kNone);
  EXPECT_TRUE(log.receives(messageOfReturn()));
  EXPECT_TRUE(camera.health().seeing);
}

TEST_F(ComingAndGoing, DoesNotBlockItsOwnerOnASilentCamera) {
  CameraOptions options = fastOptions(log);
  options.patience.silent = 60s;
  const auto token = std::make_shared<int>(0);
  options.log = [token](const std::string&) {};
  auto camera = std::make_unique<Camera>(options);
  options.log = nullptr;
  waitForPicture(*camera);
  device.fault(CameraFault::kSilent);
  std::this_thread::sleep_for(50ms);
  const auto begun = std::chrono::steady_clock::now();
  camera.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10s);
  EXPECT_EQ(token.use_count(), 1) << "its thread was abandoned";
}

/// A driver whose first call of one kind blocks until released.
struct StuckDriver final : Quirk {
  explicit StuckDriver(unsigned long where) : in{where} {}
  int call(int fd, unsigned long request, void* argument) override {
    if (request == in && !reached.exchange(true)) waitFor([this] { return !stuck; });
    return next(fd, request, argument);
  }
  const unsigned long in;
  std::atomic<bool> stuck{true}, reached{false};
  const InForce in_force{*this};  // last member: destroyed first
};

TEST_F(ComingAndGoing, DoesNotBlockItsOwnerOnABlockedDriver) {
  StuckDriver driver{VIDIOC_S_FMT};
  const auto token = std::make_shared<int>(0);
  std::atomic<int> messages{0};
  CameraOptions options = fastOptions(log);
  options.log = [token, &messages](const std::string&) { ++messages; };
  options.patience.grace = 100ms;
  auto camera = std::make_unique<Camera>(options);
  options.log = nullptr;
  ASSERT_TRUE(waitFor([&] { return driver.reached.load(); }));
  const auto begun = std::chrono::steady_clock::now();
  camera.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10s);
  EXPECT_TRUE(driver.stuck);
  device.fault(CameraFault::kGone);  // would cause a message
  driver.stuck = false;
  EXPECT_TRUE(waitFor([&] { return token.use_count() == 1; })) << "the thread still holds the callback";
  EXPECT_EQ(messages, 0);
}

TEST_F(ComingAndGoing, DoesNotReportBusyForABlockedPredecessor) {
  StuckDriver driver{VIDIOC_DQBUF};
  const auto token = std::make_shared<int>(0);
  CameraOptions options = fastOptions(log);
  options.log = [token](const std::string&) {};
  options.patience.grace = 10ms;
  auto predecessor = std::make_unique<Camera>(options);
  options.log = nullptr;
  ASSERT_TRUE(waitFor([&] { return driver.reached.load(); }));
  predecessor.reset();
  ASSERT_NE(token.use_count(), 1) << "its thread was not abandoned";
  Camera camera{fastOptions(log)};
  std::this_thread::sleep_for(100ms);  // several rejected attempts
  EXPECT_EQ(camera.health().frames, 0u);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
  driver.stuck = false;
  waitForPicture(camera);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(ComingAndGoing, TakesOverFromAProgramThatLeavesWithoutAMessage) {
  LogCapture others_log;
  auto other = std::make_unique<Camera>(fastOptions(others_log));
  waitForPicture(*other);
  Camera camera{fastOptions(log)};
  std::this_thread::sleep_for(100ms);  // several rejected attempts
  other.reset();
  waitForPicture(camera);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(ComingAndGoing, ReportsAPredecessorThatStaysBlocked) {
  StuckDriver driver{VIDIOC_DQBUF};
  CameraOptions options = fastOptions(log);
  options.patience.grace = 10ms;
  auto predecessor = std::make_unique<Camera>(options);
  ASSERT_TRUE(waitFor([&] { return driver.reached.load(); }));
  predecessor.reset();
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(log.receives(messageOf(CameraError::kBusy)));
  driver.stuck = false;
  EXPECT_TRUE(log.receives(messageOfReturn()));
}

TEST_F(ComingAndGoing, DoesNotAllocatePerPicture) {
  std::vector<long> allocations;  // of the camera's thread, at each message
  std::mutex mutex;
  CameraOptions options = fastOptions(log);
  options.log = [&](const std::string&) {
    const std::lock_guard lock{mutex};
    allocations.push_back(allocationsOfThisThread());
  };
  const auto messages = [&] {
    const std::lock_guard lock{mutex};
    return allocations.size();
  };
  Camera camera{options};
  // Between "is back" and "unplugged" only the messages allocate, regardless of the number of pictures.
  const auto comes_and_goes = [&](std::uint64_t pictures) {
    const std::size_t before = messages();
    device.fault(CameraFault::kNone);
    EXPECT_TRUE(waitFor([&] { return messages() == before + 1; }));
    EXPECT_TRUE(waitForFrames(camera, pictures));
    device.fault(CameraFault::kGone);
    EXPECT_TRUE(waitFor([&] { return messages() == before + 2; }));
    const std::lock_guard lock{mutex};
    return allocations[before + 1] - allocations[before];
  };
  ASSERT_TRUE(waitForFrames(camera, 1));
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(waitFor([&] { return messages() == 1; }));
  comes_and_goes(1);  // lets this vector grow
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
