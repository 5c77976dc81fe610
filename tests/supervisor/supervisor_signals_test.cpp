// Signals to the supervisor that are neither an order to end nor without effect, which process_fate_test.cpp has: those
// that kill it, SIGSTOP, and its commands. In each case the robot comes to rest, or is held and watched by the runtime.
#include <gtest/gtest.h>

#include <csignal>

#include "hal/signals.hpp"
#include "supervisor/home.hpp"
#include "supervisor/messages.hpp"
#include "supervisor/orders.hpp"

namespace darwinop::supervisor {
namespace {

TEST(Signals, EachOfThe31HasOneOfTheTestedEffects) {
  const std::size_t tested = signalsThat<SignalEffect::kEnds>().size() + signalsThat<SignalEffect::kIgnored>().size() +
                             signalsThat<SignalEffect::kNoEffect>().size() +
                             signalsThat<SignalEffect::kKills>().size() + signalsThat<SignalEffect::kStops>().size();
  EXPECT_EQ(tested, 31U);
  for (int number = 1; number <= 31; ++number)
    EXPECT_EQ(std::ranges::count(kSignals, number, &SignalRow::number), 1) << number;
  for (const int command : {kStopControllerSignal, kRestartControllerSignal})
    EXPECT_NE(std::ranges::find(kIgnoredSignals, command), kIgnoredSignals.end()) << "harmless to the other programs";
}

class UnderASupervisor : public Home {
 protected:
  void SetUp() override {
    Home::SetUp();
    startVirtualRobot();
    plan("hold");
    startSupervisor();
    ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  }
  void expectAllEndedAndTheRobotAtRest(const Status& before) {
    EXPECT_TRUE(within(seconds{20}, [] { return runtime::FileLock::holder(runtime::RuntimeFiles{}.loop_lock) == 0; }));
    EXPECT_TRUE(within(seconds{5}, [&] { return kill(before.controller_pid, 0) != 0; }));
    const Registers robot = registers();
    EXPECT_EQ(robot.silent, 0);
    EXPECT_EQ(robot.stiff, 0);
    EXPECT_LT(robot.furthest, 0.1);
  }
};

constexpr auto kDeadly = signalsThat<SignalEffect::kKills>();
class SupervisorKilled : public UnderASupervisor, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(By, SupervisorKilled, testing::ValuesIn(kDeadly), [](const auto& by) {
  return std::string{std::ranges::find(kSignals, by.param, &SignalRow::number)->name};
});

TEST_P(SupervisorKilled, RuntimeAndControllerEndWithTheRobotAtRest) {
  const Status before = status();
  supervisor_->kill(GetParam());
  EXPECT_NE(supervisor_->wait(seconds{10}).value_or(0), 0);
  expectAllEndedAndTheRobotAtRest(before);
}

TEST_F(UnderASupervisor, AStoppedOneLeavesTheRobotDrivingThenHeldByTheRuntimeAndContinues) {
  supervisor_->kill(SIGSTOP);
  const std::uint64_t stopped = sensors().cycle;
  ASSERT_TRUE(within(seconds{10}, [&] { return sensors().cycle > stopped + 50; }));
  EXPECT_EQ(sensors().safety.state, State::kDriven);
  const pid_t controller = status().controller_pid;
  kill(controller, SIGKILL);
  ASSERT_TRUE(within(seconds{5}, [] { return sensors().safety.state == State::kHolding; }));
  supervisor_->kill(SIGCONT);
  EXPECT_TRUE(within(seconds{30}, [&] {
    return status().controller_pid != controller && status().controller_pid != 0 &&
           sensors().safety.state == State::kDriven;
  })) << supervisor_->output();
  supervisor_->kill(SIGTERM);
  EXPECT_EQ(supervisor_->wait(seconds{30}), 0) << supervisor_->output();
  Status ended;
  ended.controller_pid = controller;
  expectAllEndedAndTheRobotAtRest(ended);
}

TEST_F(UnderASupervisor, ARuntimeThatDiesWhileItIsStoppedIsRescuedAfterwards) {
  supervisor_->kill(SIGSTOP);
  kill(status().runtime_pid, SIGKILL);
  supervisor_->kill(SIGCONT);
  ASSERT_TRUE(says(messages::kRescued, seconds{40})) << supervisor_->output();
  EXPECT_EQ(registers().stiff, 0);
}

TEST_F(UnderASupervisor, ItsTwoCommandsStopAndRestartTheController) {
  supervisor_->kill(kStopControllerSignal);
  EXPECT_TRUE(within(seconds{20}, [this] { return status().controller_ended; })) << supervisor_->output();
  EXPECT_TRUE(within(seconds{20}, [] { return sensors().safety.state == State::kLimp; }));
  supervisor_->kill(kRestartControllerSignal);
  EXPECT_TRUE(within(seconds{30}, [] { return sensors().safety.state == State::kDriven; })) << supervisor_->output();
  const Status before = status();
  supervisor_->kill(SIGTERM);
  EXPECT_EQ(supervisor_->wait(seconds{30}), 0) << supervisor_->output();
  expectAllEndedAndTheRobotAtRest(before);
}

}  // namespace
}  // namespace darwinop::supervisor
