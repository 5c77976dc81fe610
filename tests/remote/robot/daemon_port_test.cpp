// The server's robot behind a daemon: the lease comes with a client and goes with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "remote/protocol/units.hpp"
#include "remote/robot/link_port.hpp"
#include "runtime/child.hpp"
#include "runtime/daemon.hpp"
#include "runtime/daemon_link.hpp"
#include "runtime/fake_bus.hpp"
#include "runtime/operator.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// A daemon with a fake robot, 4 ms, in a child process.
class RemoteDaemonPort : public testing::Test {
 protected:
  static void serve(const runtime::RuntimeFiles& files, std::unique_ptr<runtime::Daemon>& daemon) {
    runtime::LoopConfig config;
    config.period = 4ms;
    daemon = std::make_unique<runtime::Daemon>(config, files, runtime::claimRuntime(files, getgid()), getgid(),
                                               std::make_unique<runtime::FakeBus>());
    std::thread{[&daemon] {
      static const std::atomic<bool> never{false};
      daemon->run(never);
    }}.detach();
  }

  static Request neckTo(double rad) {
    Request request;
    (void)request.motors.add(
        {.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = wireFromPosition(rad)});
    return request;
  }
  [[nodiscard]] const Sensors& seen() {
    (void)onlooker_.block().sensors.read(seen_);  // keeps the last one while there is none
    return seen_;
  }
  [[nodiscard]] double neck() { return seen().joint[index(Joint::kNeck)].position.value; }
  template <class Condition>
  void obeyUntil(const Request& request, Condition condition) {
    for (int i = 0; i < 5000 && !condition(); ++i) {
      port_.obey(request);
      std::this_thread::sleep_for(2ms);
    }
    ASSERT_TRUE(condition());
  }

  TemporaryFolder folder_;
  runtime::RuntimeFiles files_{folder_ / "runtime"};
  std::unique_ptr<runtime::Daemon> daemon_;  // lives in the child
  runtime::Child child_{[this] { serve(files_, daemon_); }};
  Sensors seen_{};
  runtime::Exchange onlooker_ = runtime::attachToDaemon(files_);
  LinkPort port_{LinkPort::Home::kDaemon, [this] { return std::make_unique<runtime::DaemonLink>(files_); }, true};
};

TEST_F(RemoteDaemonPort, HasTheLeaseWhileAClientDrivesAndLeavesTheRobotHolding) {
  EXPECT_FALSE(runtime::FileLock::holder(files_.drive_lock) > 0) << "nobody drives yet";
  port_.begin(Beginning::kFresh);
  obeyUntil(neckTo(0.5), [this] { return std::abs(neck() - 0.5) < 0.01; });
  EXPECT_EQ(port_.mustEnd(), "");
  port_.hold();
  EXPECT_TRUE(runtime::FileLock::tryTake(files_.drive_lock).has_value()) << "the next one may have it";
  std::this_thread::sleep_for(700ms);  // longer than safety's patience with who is silent
  EXPECT_EQ(seen().safety.state, State::kHolding) << "no farewell: it does not sit down";
  EXPECT_NEAR(neck(), 0.5, 0.01);

  port_.begin(Beginning::kAgain);
  obeyUntil({}, [this] { return seen().safety.state == State::kDriven; });
  EXPECT_NEAR(neck(), 0.5, 0.01);
}

TEST_F(RemoteDaemonPort, AtTheEndSaysTheFarewellOfAClientThatHasLeft) {
  port_.farewellForWhoLeft();  // nobody ever drove: nothing to say
  EXPECT_EQ(onlooker_.block().session.load(), 0u);
  port_.begin(Beginning::kFresh);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  port_.hold();
  port_.farewellForWhoLeft();
  EXPECT_TRUE(runtime::FileLock::tryTake(files_.drive_lock).has_value());
  for (int i = 0; i < 2500 && seen().safety.state != State::kKneeling; ++i) std::this_thread::sleep_for(2ms);
  EXPECT_EQ(seen().safety.state, State::kKneeling) << "before it would be given up after 10 s";
}

TEST_F(RemoteDaemonPort, ARobotThatIsLeftAloneStaysLimp) {
  while (seen().safety.state != State::kLimp) std::this_thread::sleep_for(2ms);
  port_.begin(Beginning::kFresh);
  EXPECT_EQ(port_.sensors().safety.state, State::kLimp) << "this is how the server knows";
  port_.leaveAlone();
  EXPECT_TRUE(runtime::FileLock::tryTake(files_.drive_lock).has_value());
  const std::uint64_t before = seen().cycle;
  while (seen().cycle < before + 3) std::this_thread::sleep_for(2ms);
  EXPECT_EQ(seen().safety.state, State::kLimp);
}

TEST_F(RemoteDaemonPort, CannotHaveALeaseThatAnotherHolds) {
  const runtime::Child other{[this] { static const runtime::DaemonLink link{files_}; }};
  try {
    port_.begin(Beginning::kFresh);
    FAIL() << "accepted";
  } catch (const std::runtime_error& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("another controller (pid " + std::to_string(other.pid()) + ")"));
  }
}

TEST_F(RemoteDaemonPort, EndsWhenAnOperatorReleasesTheRobot) {
  port_.begin(Beginning::kFresh);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  runtime::releaseRobot(files_);
  EXPECT_THAT(port_.mustEnd(), HasSubstr("released the robot"));
}

TEST_F(RemoteDaemonPort, NoticesThatTheDaemonWasKilled) {
  port_.begin(Beginning::kFresh);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  child_.kill(SIGKILL);
  (void)port_.mustEnd();
  std::this_thread::sleep_for(1100ms);
  EXPECT_THAT(port_.mustEnd(), HasSubstr("has not run a cycle for 1 s"));
}

}  // namespace
}  // namespace darwinop::remote
