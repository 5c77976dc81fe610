// Threads of the live comparison: change of the model, a computer that is too slow.
#include "window/live/live_thread.hpp"

#include <gmock/gmock.h>

#include "window/live/live_cycles.hpp"

namespace darwinop::window {
namespace {

using gap::live::Support;

/// Gives as many cycles as the test allows, all at once.
class FakeSource final : public CycleSource {
 public:
  explicit FakeSource(const std::atomic<std::uint64_t>& allowed) : allowed_{allowed} {}
  void poll(Nanos, const Take& take) override {
    while (given_ < allowed_) take(test::resting(++given_));
  }
  [[nodiscard]] const std::string& reason() const override { return reason_; }

 private:
  const std::atomic<std::uint64_t>& allowed_;
  std::uint64_t given_ = 0;
  std::string reason_ = "a reason";
};

class LiveThreads : public ::testing::Test {
 protected:
  template <class Done>
  LiveStatus statusWhen(Done done) {
    for (;;) {
      const LiveStatus status = thread_.status();
      if (done(status)) return status;
      std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
  }
  /// Begins, and waits until the twin's thread has taken the request.
  void begin(const std::string& model) {
    thread_.start({.model = model, .support = Support::kClamped});
    statusWhen([&](const LiveStatus& status) { return status.setting.model == model; });
  }

  std::atomic<std::uint64_t> allowed_{0};
  LiveThread thread_{[this] { return std::make_unique<FakeSource>(allowed_); }};
};

TEST_F(LiveThreads, CyclesBeyondTheQueueAreDroppedAndCounted) {
  begin("darwin-op");
  constexpr std::uint64_t kCycles = 20 * LiveThread::kMostWaiting;
  allowed_ = 1;
  statusWhen([](const LiveStatus& now) { return now.report.cycles == 1; });
  allowed_ = kCycles;
  const LiveStatus status =
      statusWhen([](const LiveStatus& now) { return now.report.cycles + now.dropped == kCycles; });
  EXPECT_GT(status.dropped, 0);
  EXPECT_EQ(status.report.missing, status.dropped) << "a gap for the twin";
  EXPECT_EQ(status.no_robot, "a reason");
}

TEST_F(LiveThreads, AnotherModelKeepsTheResidualsOfTheOneBefore) {
  begin("darwin-op");
  allowed_ = 100;
  const LiveStatus first = statusWhen([](const LiveStatus& now) { return now.report.cycles == 100; });
  EXPECT_FALSE(first.before);
  begin("webots-2013");
  const LiveStatus second = thread_.status();
  EXPECT_EQ(second.report.cycles, 0);
  EXPECT_TRUE(std::isnan(second.report.position_rad[0].rms));
  ASSERT_TRUE(second.before);
  EXPECT_EQ(second.setting_before->model, "darwin-op");
  EXPECT_EQ(second.before->position_rad[0].rms, first.report.position_rad[0].rms);
}

TEST_F(LiveThreads, AModelThatCannotBeReadIsAnError) {
  thread_.start({.model = "/nowhere/my.ini", .support = Support::kClamped});
  const LiveStatus status = statusWhen([](const LiveStatus& now) { return !now.error.empty(); });
  EXPECT_THAT(status.error, testing::HasSubstr("/nowhere/my.ini"));
}

TEST_F(LiveThreads, StopsAndStartsAgain) {
  begin("darwin-op");
  thread_.stop();
  EXPECT_FALSE(thread_.status().runs);
  begin("webots-2013");
  EXPECT_TRUE(thread_.status().runs);
}

}  // namespace
}  // namespace darwinop::window
