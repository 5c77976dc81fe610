// Operator commands: what they conclude from lock and status file.
#include "supervisor/ask.hpp"

#include <gmock/gmock.h>
#include <sys/prctl.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "runtime/child.hpp"
#include "runtime/exchange.hpp"
#include "runtime/file_lock.hpp"
#include "supervisor/messages.hpp"
#include "supervisor/status.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::supervisor {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class Ask : public testing::Test {
 protected:
  /// A supervisor that has ended; its lock file remains.
  void endedWith(const std::function<void(Status&)>& record) {
    (void)runtime::FileLock::tryTake(own_.lock);
    Status status;
    record(status);
    ASSERT_TRUE(writeStatus(status, own_.status));
  }
  /// Exit status; the output is in `said_`.
  int stop() {
    testing::internal::CaptureStdout();
    const int code = stopSupervisor(files_);
    said_ = testing::internal::GetCapturedStdout();
    return code;
  }

  TemporaryFolder folder_;
  runtime::RuntimeFiles files_{folder_ / "runtime"};
  SupervisorFiles own_{files_};
  std::string said_;
};

TEST_F(Ask, StopSucceedsIfNoSupervisorHasRun) {
  EXPECT_EQ(stop(), 0);
}

TEST_F(Ask, StopSucceedsAfterASupervisorThatRecordedRest) {
  endedWith([](Status& status) { status.at_rest = true; });
  EXPECT_EQ(stop(), 0) << said_;
}

TEST_F(Ask, StopFailsWithTheRecordedJoints) {
  endedWith([](Status& status) { status.left = "Neck has torque"; });
  EXPECT_EQ(stop(), 1);
  EXPECT_THAT(said_, HasSubstr("Neck has torque\n"));
}

TEST_F(Ask, StopFailsAfterASupervisorThatRecordedNoRest) {
  endedWith([](Status& status) { status.state = "driving"; });
  EXPECT_EQ(stop(), 1);
  EXPECT_THAT(said_, HasSubstr(messages::kNoRecordOfRest + own_.status));
}

TEST_F(Ask, StopFailsIfTheRecordIsMissing) {
  (void)runtime::FileLock::tryTake(own_.lock);
  EXPECT_EQ(stop(), 1);
  EXPECT_THAT(said_, HasSubstr(messages::kNoRecordOfRest + own_.status));
}

TEST_F(Ask, StopFailsIfAFolderHasTheNameOfTheRecord) {
  (void)runtime::FileLock::tryTake(own_.lock);
  std::filesystem::create_directories(own_.status + "/full");
  EXPECT_EQ(stop(), 1);
  EXPECT_THAT(said_, HasSubstr(messages::kNoRecordOfRest + own_.status));
}

/// Stands still unless somebody sleeps; does something at a time.
class Alarm final : public runtime::Clock {
 public:
  Alarm(Nanos at, std::function<void()> does) : at_{at}, does_{std::move(does)} {}
  [[nodiscard]] Nanos now() const noexcept override { return now_; }
  void sleepUntil(Nanos time) noexcept override {
    now_ = time;
    if (now_ >= at_) std::exchange(does_, [] {})();
  }

 private:
  Nanos now_{0}, at_;
  std::function<void()> does_;
};

TEST_F(Ask, StopWaitsAsLongAsTheRobotNeedsToSitDown) {
  const runtime::Exchange loop = runtime::Exchange::create(files_.exchange);
  for (const auto& [gentle_speed, ends, waits] : {std::tuple{1.194F, 55s, true}, std::tuple{1.194F, 70s, false},
                                                  std::tuple{0.05F, 193s, true}, std::tuple{0.05F, 230s, false}}) {
    Sensors seen;
    seen.safety.gentle_speed = gentle_speed;
    loop.ownBlock().sensors.publish(seen);
    runtime::Child supervisor{[this] {
      std::signal(SIGTERM, SIG_IGN);  // busy
      static const auto lock = runtime::FileLock::tryTake(own_.lock);
    }};
    Alarm clock{ends, [&] { supervisor.kill(SIGKILL); }};
    bool waited = true;
    try {
      EXPECT_EQ(stopSupervisor(files_, clock), 1) << "no record of rest";
    } catch (const std::runtime_error&) {
      waited = false;
    }
    EXPECT_EQ(waited, waits) << gentle_speed << " rad/s, " << ends.count() << " s";
  }
}

TEST_F(Ask, StatusEscapesTheNameThatTheDriverGaveItself) {
  const auto supervisor = runtime::FileLock::tryTake(own_.lock);
  ASSERT_TRUE(writeStatus(Status{}, own_.status));
  std::optional<runtime::FileLock> lease;
  const runtime::Child driver{[&] {
    prctl(PR_SET_NAME, "\x1b[2Jfree");
    lease = runtime::FileLock::tryTake(files_.drive_lock);
  }};
  testing::internal::CaptureStdout();
  EXPECT_EQ(printStatus(files_), 0);
  const std::string shown = testing::internal::GetCapturedStdout();
  EXPECT_THAT(shown, HasSubstr("pid " + std::to_string(driver.pid()) + ", \\x1b[2Jfree\n"));
  EXPECT_THAT(shown, testing::Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace darwinop::supervisor
