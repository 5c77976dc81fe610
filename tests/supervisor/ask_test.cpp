// Operator commands: what they conclude from lock and status file.
#include "supervisor/ask.hpp"

#include <gmock/gmock.h>
#include <sys/prctl.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "runtime/child.hpp"
#include "runtime/file_lock.hpp"
#include "supervisor/messages.hpp"
#include "supervisor/status.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::supervisor {
namespace {

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
