// LinkPort with a daemon: a client's session holds the lease.
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
#include "runtime/messages.hpp"
#include "runtime/operator.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// A daemon with a fake robot and a period of 4 ms, in a child process.
class RemoteDaemonPort : public testing::Test {
 protected:
  static void serve(const runtime::RuntimeFiles& files, std::unique_ptr<runtime::Daemon>& daemon) {
    runtime::LoopConfig config;
    config.period = 4ms;
    daemon = std::make_unique<runtime::Daemon>(config, files, runtime::claimRuntime(files, getgid()), getgid(),
                                               std::make_unique<runtime::FakeBus>());
    static std::atomic<bool> stop{false};
    std::signal(SIGTERM, [](int) { stop = true; });
    std::thread{[&daemon] { (void)daemon->run(stop); }}.detach();
  }

  static Request neckTo(double rad) {
    Request request;
    (void)request.motors.add(
        {.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = wireFromPosition(rad)});
    return request;
  }
  [[nodiscard]] const Sensors& seen() {
    (void)observer_.block().sensors.read(seen_);  // keeps the previous image if there is no new one
    return seen_;
  }
  [[nodiscard]] double neck() { return seen().joint[index(Joint::kNeck)].position.value; }
  template <class Condition>
  void obeyUntil(const Request& request, Condition condition) {
    for (int i = 0; i < 5000 && !condition(); ++i) {
      port_.apply(request);
      std::this_thread::sleep_for(2ms);
    }
    ASSERT_TRUE(condition());
  }

  TemporaryFolder folder_;
  runtime::RuntimeFiles files_{folder_ / "runtime"};
  std::unique_ptr<runtime::Daemon> daemon_;  // lives in the child
  runtime::Child child_{[this] { serve(files_, daemon_); }};
  Sensors seen_{};
  runtime::Exchange observer_ = runtime::attachToDaemon(files_);
  LinkPort port_{LinkPort::Home::kDaemon, [this] { return std::make_unique<runtime::DaemonLink>(files_); }, true};
};

TEST_F(RemoteDaemonPort, HoldsTheLeaseDuringASessionAndLeavesTheRobotHolding) {
  EXPECT_FALSE(runtime::FileLock::holder(files_.drive_lock) > 0) << "not driven yet";
  port_.startSession(SessionStart::kNew);
  obeyUntil(neckTo(0.5), [this] { return std::abs(neck() - 0.5) < 0.01; });
  EXPECT_EQ(port_.endReason(), "");
  port_.hold();
  EXPECT_TRUE(runtime::FileLock::tryTake(files_.drive_lock).has_value()) << "the next one may have it";
  std::this_thread::sleep_for(700ms);  // longer than safety's timeout for a silent driver
  EXPECT_EQ(seen().safety.state, State::kHolding) << "the session was not ended: it does not sit down";
  EXPECT_NEAR(neck(), 0.5, 0.01);

  port_.startSession(SessionStart::kResumed);
  obeyUntil({}, [this] { return seen().safety.state == State::kDriven; });
  EXPECT_NEAR(neck(), 0.5, 0.01);
}

TEST_F(RemoteDaemonPort, EndsTheSessionOfADisconnectedClientAtTheEnd) {
  port_.endAbandonedSession();  // no client has driven: no session to end
  EXPECT_EQ(observer_.block().session.load(), 0u);
  port_.startSession(SessionStart::kNew);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  port_.hold();
  port_.endAbandonedSession();
  EXPECT_TRUE(runtime::FileLock::tryTake(files_.drive_lock).has_value());
  for (int i = 0; i < 2500 && seen().safety.state != State::kKneeling; ++i) std::this_thread::sleep_for(2ms);
  EXPECT_EQ(seen().safety.state, State::kKneeling) << "before it would be given up after 10 s";
}

TEST_F(RemoteDaemonPort, LeavesARobotAloneThatAnotherProgramLeftHolding) {
  port_.startSession(SessionStart::kNew);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  port_.hold();
  {
    runtime::DriverSession other{std::make_unique<runtime::DaemonLink>(files_)};
    other.start();
    Commands commands;
    commands.start_where_it_is = true;
    const std::uint32_t before = seen().safety.session;
    for (int i = 0; i < 2500 && !(other.drives(seen()) && seen().safety.session != before); ++i) {
      other.publish(commands);
      std::this_thread::sleep_for(2ms);
    }
    other.hold(commands);
  }
  for (int i = 0; i < 2500 && seen().safety.state != State::kHolding; ++i) std::this_thread::sleep_for(2ms);
  const std::uint32_t session = observer_.block().session.load();
  port_.endAbandonedSession();
  port_.startSession(SessionStart::kNew);  // a client that is refused
  port_.cancelSession();
  port_.endAbandonedSession();
  const std::uint64_t after = seen().cycle + 10;
  while (seen().cycle < after) std::this_thread::sleep_for(2ms);
  EXPECT_EQ(seen().safety.state, State::kHolding);
  EXPECT_EQ(observer_.block().session.load(), session);
}

TEST_F(RemoteDaemonPort, ACancelledSessionLeavesTheRobotLimp) {
  while (seen().safety.state != State::kLimp) std::this_thread::sleep_for(2ms);
  port_.startSession(SessionStart::kNew);
  EXPECT_EQ(port_.sensors().safety.state, State::kLimp) << "the server checks this state";
  port_.cancelSession();
  EXPECT_TRUE(runtime::FileLock::tryTake(files_.drive_lock).has_value());
  const std::uint64_t before = seen().cycle;
  while (seen().cycle < before + 3) std::this_thread::sleep_for(2ms);
  EXPECT_EQ(seen().safety.state, State::kLimp);
}

TEST_F(RemoteDaemonPort, CannotTakeALeaseThatAnotherProcessHolds) {
  const runtime::Child other{[this] { static const runtime::DaemonLink link{files_}; }};
  try {
    port_.startSession(SessionStart::kNew);
    FAIL() << "accepted";
  } catch (const std::runtime_error& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("pid " + std::to_string(other.pid())));
  }
}

TEST_F(RemoteDaemonPort, EndsWhenAnOperatorReleasesTheRobot) {
  port_.startSession(SessionStart::kNew);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  runtime::releaseRobot(files_);
  EXPECT_THAT(port_.endReason(), HasSubstr(std::string{row(Fault::kReleasedByOperator).meaning}));
}

TEST_F(RemoteDaemonPort, ADaemonThatEndsStillTakesTheLastSteps) {
  port_.startSession(SessionStart::kNew);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  EXPECT_EQ(port_.endRequest(), "");
  ASSERT_EQ(::kill(child_.pid(), SIGTERM), 0);
  obeyUntil(neckTo(0.1), [this] { return !port_.endReason().empty() || !port_.endRequest().empty(); });
  EXPECT_EQ(port_.endRequest(), runtime::messages::kRuntimeEnds);
  obeyUntil(neckTo(0.2), [this] { return std::abs(neck() - 0.2) < 0.01; });
  EXPECT_EQ(port_.endReason(), "");
  EXPECT_EQ(seen().safety.state, State::kDriven);
  port_.endSession();
  for (int i = 0; i < 2500 && seen().safety.state != State::kKneeling; ++i) std::this_thread::sleep_for(2ms);
  EXPECT_EQ(seen().safety.state, State::kKneeling);
}

TEST_F(RemoteDaemonPort, DetectsThatTheDaemonWasKilled) {
  port_.startSession(SessionStart::kNew);
  obeyUntil(neckTo(0.1), [this] { return seen().safety.state == State::kDriven; });
  child_.kill(SIGKILL);
  (void)port_.endReason();
  std::this_thread::sleep_for(1100ms);
  EXPECT_EQ(port_.endReason(), LinkPort::kNoCycle);
}

}  // namespace
}  // namespace darwinop::remote
