// The embedded home in real time: a thread, real-time priority, stopping.
#include <gmock/gmock.h>
#include <pthread.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "child.hpp"
#include "environment.hpp"
#include "fake_bus.hpp"
#include "runtime/threaded_link.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::runtime {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

LoopConfig quick() {
  LoopConfig config;
  config.period = 2ms;
  config.safety.on_exit = safety::OnExit::kLimp;
  return config;
}

TEST(ThreadedLink, RunsCyclesOnItsOwnAndLetsTheControllerWaitForThem) {
  ThreadedLink link{quick(), std::make_unique<FakeBus>()};
  const std::atomic<bool> stop{false};
  const Nanos start = link.now();
  for (int i = 0; i < 50; ++i) {
    Commands commands;
    commands.joint[index(Joint::kNeck)].setGoal(Rad{0.01 * i});
    link.publish(commands);
    const std::uint64_t next = link.sensors().cycle + 1;
    ASSERT_TRUE(link.waitForCycle(next, stop));
    ASSERT_GE(link.sensors().cycle, next);
  }
  EXPECT_GE(link.now() - start, 98ms) << "50 cycles of 2 ms cannot be over sooner";
  EXPECT_TRUE(link.realTime());
  EXPECT_EQ(link.period(), 2ms);
}

TEST(ThreadedLink, AnotherThreadCanEndTheWait) {
  ThreadedLink link{quick(), std::make_unique<FakeBus>()};
  std::atomic<bool> stop{false};
  std::thread other{[&] { stop = true; }};
  EXPECT_FALSE(link.waitForCycle(1'000'000, stop));
  EXPECT_EQ(link.whyEnded(), kAskedToStop);
  other.join();
}

TEST(ThreadedLink, GoesOnWhileTheControllerDoesNothing) {
  ThreadedLink link{quick(), std::make_unique<FakeBus>()};
  link.publish({});
  std::this_thread::sleep_for(100ms);
  EXPECT_GT(link.sensors().cycle, 10u);
}

TEST(ThreadedLink, ReportsAFaultWhileItRuns) {
  testing::internal::CaptureStderr();
  {
    ThreadedLink link{quick(), std::make_unique<FakeBus>()};
    link.publish({});
    std::this_thread::sleep_for(700ms);
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("darwinop: fault 40 controller_stalled: "));
  }
}

/// Runs in a process without rights, for any user; returns what it prints.
std::string asNobody(RealTime demand) {
  const TemporaryFolder folder;
  chmod((folder / "").c_str(), 0777);
  const std::string said = folder / "said";
  const Child child{[&] {
    const bool dropped = getuid() != 0 || setuid(65534) == 0;
    std::ofstream out{said};
    try {
      LoopConfig config = quick();
      config.real_time.demand = demand;
      const ThreadedLink link{config, std::make_unique<FakeBus>()};
      out << (dropped ? "warned: " : "still root: ") << link.warning();
    } catch (const std::runtime_error& error) {
      out << "refused: " << error.what();
    }
  }};
  return textOf(said);
}

TEST(RealTimeDemand, RequiredButRefusedIsAnErrorThatNamesTheRemedy) {
  const std::string said = asNobody(RealTime::kRequired);
  EXPECT_THAT(said, StartsWith("refused: "));
  EXPECT_THAT(said, HasSubstr("rtprio"));
  EXPECT_THAT(said, HasSubstr("DARWINOP_REALTIME=if-allowed"));
}

TEST(RealTimeDemand, IfAllowedButRefusedIsAWarning) {
  EXPECT_THAT(asNobody(RealTime::kIfAllowed), AllOf(StartsWith("warned: "), HasSubstr("rtprio")));
}

TEST(RealTimeDemand, IsReadFromTheEnvironmentAndNothingElseIsTakenForIt) {
  EXPECT_EQ(realTimeFromEnvironment(), RealTime::kIfAllowed);
  const Environment requested{"DARWINOP_REALTIME", "required"};
  EXPECT_EQ(realTimeFromEnvironment(), RealTime::kRequired);
  EXPECT_THROW(realTimeFromText("always"), std::runtime_error);
}

}  // namespace
}  // namespace darwinop::runtime
