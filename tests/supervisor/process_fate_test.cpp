// Effect of signals, closed pipes and truncated files on the robot. Table: hal/signals.hpp.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hal/signals.hpp"
#include "runtime/messages.hpp"
#include "supervisor/home.hpp"
#include "supervisor/messages.hpp"

namespace darwinop::supervisor {
namespace {

using testing::HasSubstr;

std::string nameOf(int signal) {
  return std::string{std::ranges::find(kSignals, signal, &SignalRow::number)->name};
}

/// A virtual robot, and programs on it without a supervisor.
class Fate : public Home {
 protected:
  void SetUp() override {
    Home::SetUp();
    startVirtualRobot();
    std::ofstream{file("plan")} << "hold\n";
    std::filesystem::create_symlink(controller(), folder_ / "walk");
  }
  void TearDown() override {
    driver_.reset();
    daemon_.reset();
    Home::TearDown();
  }
  void startDaemon() {
    daemon_ =
        std::make_unique<Program>(std::vector<std::string>{program("darwinop-runtime"), "--robot", port()}, file("d"));
    ASSERT_TRUE(daemon_->says("ready:", seconds{15})) << daemon_->output();
  }
  /// Returns when the robot stands.
  void startController(const std::string& robot) {
    setenv("DARWINOP_ROBOT", robot.c_str(), 1);
    driver_ = std::make_unique<Program>(std::vector<std::string>{file("walk")}, file("c"));
    unsetenv("DARWINOP_ROBOT");
    ASSERT_TRUE(driver_->says("stands", seconds{20})) << driver_->output();
  }
  /// The controller hosts the loop. Returns when the robot stands.
  void startRun() {
    driver_ = std::make_unique<Program>(
        std::vector<std::string>{program("darwinop-run"), "--robot", port(), file("walk")}, file("c"));
    ASSERT_TRUE(driver_->says("stands", seconds{20})) << driver_->output();
  }
  void sendAllWithoutEffect(Program& to, std::initializer_list<int> but = {}) {
    for (const SignalRow& row : kSignals) {
      const bool harmless = row.effect == SignalEffect::kIgnored || row.effect == SignalEffect::kNoEffect;
      if (harmless && std::ranges::find(but, row.number) == but.end()) to.kill(row.number);
    }
    to.kill(SIGRTMIN);
    to.kill(SIGRTMAX);
    std::this_thread::sleep_for(milliseconds{500});
    std::string state;
    std::ifstream file{"/proc/" + std::to_string(to.pid()) + "/stat"};
    for (int word = 0; word < 3; ++word) file >> state;
    EXPECT_TRUE(state == "S" || state == "R" || state == "D") << "neither stopped nor ended: " << state;
  }
  static std::vector<std::string> window() { return {program("darwinop-window"), "--robot", "runtime", "--port", "0"}; }
  void expectAtRest() {
    const Registers robot = registers();
    EXPECT_EQ(robot.silent, 0);
    EXPECT_EQ(robot.stiff, 0);
  }

  std::unique_ptr<Program> daemon_, driver_;
};

TEST_F(Fate, SignalsWithoutEffectLeaveDaemonAndItsControllerDriving) {
  startDaemon();
  startController("runtime");
  sendAllWithoutEffect(*daemon_);
  sendAllWithoutEffect(*driver_);
  const Sensors before = sensors();
  std::this_thread::sleep_for(milliseconds{300});
  EXPECT_GT(sensors().cycle, before.cycle + 5);
  EXPECT_EQ(sensors().safety.state, State::kDriven);
}

TEST_F(Fate, SignalsWithoutEffectLeaveAnEmbeddedControllerDriving) {
  startController(port());
  sendAllWithoutEffect(*driver_);
  driver_->kill(SIGTERM);
  EXPECT_EQ(driver_->wait(seconds{30}), 0) << driver_->output();
  expectAtRest();
}

TEST_F(Fate, SignalsWithoutEffectLeaveARunAndItsControllerDriving) {
  startRun();
  sendAllWithoutEffect(*driver_);
  EXPECT_THROW((void)registers(), std::runtime_error) << "the controller has the port";
  driver_->kill(SIGTERM);
  EXPECT_EQ(driver_->wait(seconds{30}), 0) << driver_->output();
  expectAtRest();
}

TEST_F(Fate, AStoppedRunLeavesItsControllerDriving) {
  startRun();
  driver_->kill(SIGSTOP);
  std::this_thread::sleep_for(milliseconds{700});
  EXPECT_THROW((void)registers(), std::runtime_error) << "the controller has the port";
  driver_->kill(SIGCONT);
  driver_->kill(SIGTERM);
  EXPECT_EQ(driver_->wait(seconds{30}), 0) << driver_->output();
  expectAtRest();
}

constexpr auto kKillSignals = signalsThat<SignalEffect::kKills>();
class KillSignal : public Fate, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Each, KillSignal, testing::ValuesIn(kKillSignals),
                         [](const auto& by) { return nameOf(by.param); });

TEST_P(KillSignal, OfARunEndsItsControllerWithTheRobotAtRest) {
  startRun();
  driver_->kill(GetParam());
  EXPECT_NE(driver_->wait(seconds{30}).value_or(0), 0);
  ASSERT_TRUE(driver_->says("end requested", seconds{20})) << driver_->output();
  EXPECT_TRUE(within(seconds{30}, [this] {
    try {
      return registers().stiff == 0;
    } catch (const std::runtime_error&) {
      return false;  // the controller has the port
    }
  }));
  expectAtRest();
}

#ifdef DARWINOP_WITH_WINDOW
TEST_F(Fate, AWindowThatIsKilledOrStoppedLeavesTheRobotDriving) {
  startDaemon();
  startController("runtime");
  const auto driving = [](std::uint64_t since) {
    return sensors().cycle > since + 5 && sensors().safety.state == State::kDriven;
  };
  for (const SignalRow& row : kSignals) {
    if (row.effect != SignalEffect::kKills && row.effect != SignalEffect::kStops) continue;
    Program one{window(), file("one")};
    ASSERT_TRUE(one.says("http://", seconds{20})) << one.output();
    one.kill(row.number);
    if (row.effect == SignalEffect::kKills) {
      EXPECT_NE(one.wait(seconds{10}).value_or(0), 0) << row.name;
    }
    const std::uint64_t before = sensors().cycle;
    EXPECT_TRUE(within(seconds{5}, [&] { return driving(before); })) << row.name;
  }
}
#endif

class EndSignal : public Fate, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Each, EndSignal, testing::ValuesIn(kEndSignals),
                         [](const auto& by) { return nameOf(by.param); });

TEST_P(EndSignal, EndsADaemonWithTheRobotAtRest) {
  startDaemon();
  startController("runtime");
  daemon_->kill(GetParam());
  EXPECT_EQ(daemon_->wait(seconds{30}), 0) << daemon_->output();
  EXPECT_EQ(driver_->wait(seconds{10}), 0) << driver_->output();
  expectAtRest();
}

TEST_P(EndSignal, EndsAnEmbeddedControllerWithTheRobotAtRest) {
  startController(port());
  driver_->kill(GetParam());
  EXPECT_EQ(driver_->wait(seconds{30}), 0) << driver_->output();
  EXPECT_THAT(driver_->output(), HasSubstr("end requested"));
  expectAtRest();
}

TEST_P(EndSignal, EndsARunAndItsControllerWithTheRobotAtRest) {
  startRun();
  driver_->kill(GetParam());
  EXPECT_EQ(driver_->wait(seconds{30}), 0) << driver_->output();
  EXPECT_THAT(driver_->output(), HasSubstr("end requested"));
  expectAtRest();
}

bool hasStarted(const std::string& output) {
  return std::ranges::any_of(std::array{"ready:", "body:", "http://", "camera:", "port:"},
                             [&](const char* text) { return output.find(text) != std::string::npos; });
}

TEST_P(EndSignal, EndsTheOtherProgramsNormally) {
  startDaemon();
  const std::vector<std::vector<std::string>> all{
      {program("darwinop-remote"), "--robot", "runtime", "--port", "0"},
      {program("darwinop-monitor"), "--port", "0"},
#ifdef DARWINOP_WITH_WINDOW
      window(),
#endif
#ifdef DARWINOP_WITH_TWIN
      {program("darwinop-twin"), "view", "--record", file("film"), "--size", "32x32", "--fps", "5"},
      {program("darwinop-virtual-camera"), "--file", file("frames")},
#endif
      {program("darwinop-virtual-robot"), "--link", file("other")}};
  for (const std::vector<std::string>& command : all) {
    Program one{command, file("one")};
    ASSERT_TRUE(within(seconds{20}, [&] { return hasStarted(one.output()); })) << command[0] << one.output();
    std::this_thread::sleep_for(milliseconds{200});
    sendAllWithoutEffect(
        one, command[0].ends_with("robot") ? std::initializer_list<int>{SIGUSR1} : std::initializer_list<int>{});
    one.kill(GetParam());
    EXPECT_EQ(one.wait(seconds{60}), 0) << command[0] << one.output();  // a film is first rendered to its end
  }
}

#ifdef DARWINOP_WITH_TWIN
TEST_F(Fate, AVirtualCameraThatIsKilledEndsWhatItStarted) {
  Program camera{{program("darwinop-virtual-camera"), "--", "/bin/sh", "-c",
                  "trap 'echo ended; exit' TERM; echo started; while sleep 0.1; do :; done"},
                 file("camera")};
  ASSERT_TRUE(camera.says("started", seconds{20})) << camera.output();
  camera.kill(SIGKILL);
  EXPECT_TRUE(camera.says("ended", seconds{20}));
}
#endif

TEST_P(EndSignal, EndsASupervisorWithTheRobotAtRest) {
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  sendAllWithoutEffect(*supervisor_, {SIGUSR1, SIGUSR2});  // these are commands
  supervisor_->kill(GetParam());
  EXPECT_EQ(supervisor_->wait(seconds{30}), 0) << supervisor_->output();
  expectAtRest();
}

TEST_F(Fate, ADaemonWithUnreadOutputContinuesThroughAFault) {
  const std::string fifo = file("fifo");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  const int reader = open(fifo.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  daemon_ = std::make_unique<Program>(std::vector<std::string>{program("darwinop-runtime"), "--robot", port()}, fifo);
  ASSERT_TRUE(within(seconds{15}, [] { return sensors().cycle > 0; }));
  startController("runtime");
  close(reader);
  driver_->kill(SIGSTOP);  // causes a reported fault: the controller stalls
  ASSERT_TRUE(within(seconds{5}, [] { return sensors().safety.active.any(); }));
  std::this_thread::sleep_for(milliseconds{300});
  EXPECT_EQ(sensors().safety.state, State::kHolding);
  driver_->kill(SIGKILL);
  daemon_->kill(SIGTERM);
  EXPECT_EQ(daemon_->wait(seconds{30}), 0);
  expectAtRest();
}

class ShortenedUnderASupervisor : public Home, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Each, ShortenedUnderASupervisor, testing::Values("", ".commands"),
                         [](const auto& file) { return *file.param == 0 ? "Exchange" : "Commands"; });

TEST_P(ShortenedUnderASupervisor, TheRobotStillComesToRestAndTheSupervisorContinues) {
  startVirtualRobot();
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  const std::string path = runtime::RuntimeFiles{}.exchange;
  ASSERT_EQ(truncate((path + GetParam()).c_str(), 0), 0);
  ASSERT_TRUE(says(messages::kRescued, seconds{40})) << supervisor_->output();
  const Registers robot = registers();
  EXPECT_EQ(robot.stiff, 0);
  EXPECT_LT(robot.furthest, 0.1);
  EXPECT_EQ(ask("--status"), 0) << said_;
  EXPECT_EQ(ask("--restart-controller"), 0) << said_;
  EXPECT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  EXPECT_EQ(ask("--stop"), 0) << said_;
}

TEST_F(Home, CommandsReachOnlyASupervisorOfTheSameUserOrRoot) {
  const SupervisorFiles files{runtime::RuntimeFiles{}};
  ASSERT_EQ(mkfifo(files.lock.c_str(), 0666), 0);
  EXPECT_EQ(ask("--stop"), 1);
  EXPECT_THAT(said_, HasSubstr(runtime::messages::kNotARegularFile));
  ASSERT_EQ(unlink(files.lock.c_str()), 0);
  if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";

  // Another user creates and locks the file, and writes the pid of a root process.
  Program victim{{"/bin/sleep", "60"}, file("victim")};
  std::ofstream{files.lock} << victim.pid() << '\n';
  ASSERT_EQ(chown(files.lock.c_str(), 65534, 65534), 0);
  const auto held = std::make_unique<Program>(
      std::vector<std::string>{"/usr/bin/flock", "--no-fork", files.lock, "/bin/sleep", "60"}, file("thief"));
  std::this_thread::sleep_for(milliseconds{300});
  for (const char* order : {"--stop", "--stop-controller", "--restart-controller", "--status"}) {
    EXPECT_EQ(ask(order), 1);
    EXPECT_THAT(said_, HasSubstr("uid 65534")) << order;
  }
  EXPECT_EQ(kill(victim.pid(), 0), 0);
  EXPECT_EQ(victim.wait(seconds{0}), std::nullopt) << "no signal was sent";
}

}  // namespace
}  // namespace darwinop::supervisor
