// A whole loop in simulated time: what a controller sees, what an operator can do, what is left behind.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <random>
#include <regex>

#include "environment.hpp"
#include "runtime/operator.hpp"
#include "runtime/recorder.hpp"
#include "runtime/recording_file.hpp"
#include "runtime/report.hpp"
#include "simulated_robot.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::runtime {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

Commands neckTo(double angle) {
  Commands commands;
  commands.start_where_it_is = true;
  commands.joint[index(Joint::kNeck)].setGoal(Rad{angle});
  return commands;
}

TEST(Lockstep, RunsExactlyTheCyclesThatAreWaitedFor) {
  SimulatedRobot sim;
  const Nanos start = sim.link->now();
  EXPECT_EQ(sim.robot->reads, 0u);
  EXPECT_TRUE(sim.link->waitForCycle(5, sim.stop));
  EXPECT_TRUE(sim.link->waitForCycle(5, sim.stop)) << "it is over already";
  EXPECT_TRUE(sim.link->waitForCycle(3, sim.stop));
  EXPECT_EQ(sim.robot->reads, 5u);
  EXPECT_EQ(sim.link->sensors().cycle, 5u);
  EXPECT_EQ(sim.link->now() - start, 5 * 16ms);
  EXPECT_EQ(Nanos{sim.link->sensors().time_ns}, sim.link->now());
}

TEST(Lockstep, CarriesCommandsToTheRobotAndSensorsBack) {
  SimulatedRobot sim;
  sim.step(neckTo(0.3), 300);
  const Sensors seen = sim.link->sensors();
  EXPECT_EQ(seen.safety.state, State::kDriven);
  EXPECT_NEAR(seen.joint[index(Joint::kNeck)].position.value, 0.3, 1e-9);
}

TEST(Lockstep, EndsWithASentenceWhenAskedToStop) {
  SimulatedRobot sim;
  sim.step({}, 3);
  sim.stop = true;
  EXPECT_FALSE(sim.link->waitForCycle(100, sim.stop));
  EXPECT_EQ(sim.link->sensors().cycle, 3u);
  EXPECT_EQ(sim.link->whyEnded(), kAskedToStop);
}

class OnExit : public testing::TestWithParam<safety::OnExit> {};

TEST_P(OnExit, LeavesTheRobotAsTheSettingSays) {
  LoopConfig config;
  config.safety.on_exit = GetParam();
  SimulatedRobot sim{config};
  sim.step(neckTo(0.5), 300);
  ASSERT_FALSE(sim.limp());
  sim.link.reset();
  EXPECT_EQ(sim.limp(), GetParam() != safety::OnExit::kHold);
  const double neck = sim.robot->position[index(Joint::kNeck)].value;
  if (GetParam() == safety::OnExit::kKneel)
    EXPECT_NEAR(neck, radFromTicks(row(Joint::kNeck).start).value, 0.01);
  else
    EXPECT_NEAR(neck, 0.5, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, OnExit,
                         testing::Values(safety::OnExit::kHold, safety::OnExit::kKneel, safety::OnExit::kLimp));

TEST(Lockstep, AControllerThatNeverDroveLeavesTheRobotAlone) {
  SimulatedRobot sim;
  (void)sim.link->waitForCycle(10, sim.stop);
  sim.link.reset();
  EXPECT_EQ(sim.robot->writes, 0u);
}

TEST(Lockstep, TheSameRunGivesTheSameRecordingButForItsDate) {
  const TemporaryFolder folder;
  std::string text[2];
  for (std::string& run : text) {
    LoopConfig config;
    config.record_path = folder / "log.csv";
    {
      SimulatedRobot sim{config};
      for (int i = 0; i < 700; ++i) sim.step(neckTo(0.001 * i));
    }
    run = std::regex_replace(textOf(config.record_path), std::regex{"# date: .*"}, "");
  }
  EXPECT_EQ(text[0], text[1]);
  EXPECT_GT(std::count(text[0].begin(), text[0].end(), '\n'), 700) << "more cycles than the ring holds, none lost";
  EXPECT_THAT(text[0], testing::Not(HasSubstr(kLostRows)));
}

TEST(Lockstep, OthersCanLookOnAndTheFiguresSurviveTheController) {
  const TemporaryFolder folder;
  const Environment exchange{"DARWINOP_EXCHANGE", folder / "x"};
  LoopConfig config;
  config.safety.on_exit = safety::OnExit::kHold;
  {
    SimulatedRobot sim{config};
    sim.robot->dead[index(Joint::kFootL)] = true;
    sim.step({}, 20);
  }
  const Exchange left = Exchange::attach(folder / "x", Exchange::Access::kRead);
  StatsView stats;
  left.block().stats.copyTo(stats);
  Sensors last;
  ASSERT_TRUE(left.block().sensors.read(last));
  EXPECT_EQ(stats.cycles, 23u) << "20 and three for the end of session";
  EXPECT_THAT(reportText(stats, last), HasSubstr("FootL"));
  EXPECT_EQ(Nanos{left.block().info.period_ns}, 16ms);
}

/// A loop whose commands come through files, in simulated time.
struct Operated {
  TemporaryFolder folder;
  std::shared_ptr<FakeRobot> robot = std::make_shared<FakeRobot>();
  LoopConfig config;
  Exchange exchange = Exchange::create(folder / "x");
  LoopHost host{config, std::make_unique<FakeBus>(robot), exchange, LoopStats::Timed::kNo, Recorder::Writer::kByHand};
  ScriptedClock clock;
  LockstepDriver driver{host.loop(), clock, config.period};
  Exchange desk = Exchange::attach(folder / "x");
  std::uint64_t sequence = 0;

  void step(Commands commands, std::uint32_t session, int times) {
    commands.session = session;
    for (int i = 0; i < times; ++i) {
      commands.sequence = ++sequence;
      desk.commands().commands.publish(commands);
      driver.run(1);
    }
  }
  /// The number that a driver who comes now chooses.
  [[nodiscard]] std::uint32_t nextSession() const { return desk.block().session.load() + 1; }
  [[nodiscard]] bool limp() const {
    return std::none_of(robot->torque.begin(), robot->torque.end(), [](bool on) { return on; });
  }
  [[nodiscard]] double neck() const { return robot->position[index(Joint::kNeck)].value; }
  [[nodiscard]] Sensors sensors() const {
    Sensors seen;
    (void)desk.block().sensors.read(seen);
    return seen;
  }
};

TEST(Operator, ReleaseTakesAllTorqueAwayAndHoldsWhateverTheControllerDoes) {
  Operated o;
  o.step(neckTo(0.5), 1, 300);
  ASSERT_FALSE(o.limp());
  o.desk.commands().release.ask();
  o.step(neckTo(0.5), 1, 10);
  EXPECT_TRUE(o.limp());
  o.step(neckTo(-0.5), 1, 2000);
  EXPECT_TRUE(o.limp());
  EXPECT_EQ(o.desk.block().refused.load(), 1u);
  EXPECT_EQ(o.sensors().safety.worst, Fault::kReleasedByOperator);
  EXPECT_NEAR(o.neck(), 0.5, 1e-9);
}

TEST(Operator, ReleaseHoldsAlsoForADriverWithANumberOfItsOwnMaking) {
  for (const std::uint32_t session : {7u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
    Operated o;
    o.step(neckTo(0.5), session, 300);
    ASSERT_FALSE(o.limp());
    o.desk.commands().release.ask();
    o.step(neckTo(-0.5), session, 100);
    EXPECT_TRUE(o.limp()) << session;
  }
}

TEST(Operator, AfterAReleaseTheNextSessionTakesOver) {
  Operated o;
  o.step(neckTo(0.5), 1, 300);
  o.desk.commands().release.ask();
  o.step(neckTo(0.5), 1, 10);
  o.step(neckTo(0.4), o.nextSession(), 300);
  EXPECT_FALSE(o.limp());
  EXPECT_NEAR(o.neck(), 0.4, 1e-9);
}

TEST(Operator, ClosingTheLoopBringsTheRobotToRestEvenWithAControllerThatGoesOn) {
  Operated o;
  o.step(neckTo(0.5), 1, 300);
  o.exchange.ownBlock().closing.store(1);
  o.step(neckTo(0.5), 1, 400);
  EXPECT_TRUE(o.limp());
}

TEST(Exchange, LostToSomebodyWhoShortensItsFilesTheLoopBringsTheRobotToRest) {
  for (const char* file : {"x", "x.commands"}) {
    Operated o;
    o.step(neckTo(0.5), 1, 300);
    ASSERT_FALSE(o.limp());
    ASSERT_EQ(truncate((o.folder / file).c_str(), 0), 0);
    o.step(neckTo(0.5), 1, 400);
    EXPECT_TRUE(o.limp()) << file;
    EXPECT_TRUE(o.exchange.shortened());
  }
}

/// Whatever a controller writes where it should not: the loop goes on, and the next controller drives.
TEST(Exchange, NoStrayWriteToTheCommandsKeepsTheNextControllerFromDriving) {
  std::mt19937 random{7};
  for (int run = 0; run < 40; ++run) {
    Operated o;
    o.step(neckTo(0.2), 1, 60);
    auto* const bytes = reinterpret_cast<unsigned char*>(&o.desk.commands());
    const std::size_t begin = run % 4 == 0 ? 0 : random() % sizeof(CommandBlock);
    const std::size_t end = run % 4 == 0 ? sizeof(CommandBlock) : std::min(begin + 64, sizeof(CommandBlock));
    const auto fill = static_cast<unsigned char>(run % 3 == 0 ? 0xFF : run % 3 == 1 ? 0 : random());
    for (std::size_t i = begin; i < end; ++i) bytes[i] = run % 5 == 0 ? static_cast<unsigned char>(random()) : fill;
    const std::uint64_t before = o.sensors().cycle;
    o.driver.run(5);
    EXPECT_EQ(o.sensors().cycle, before + 5);
    EXPECT_EQ(o.desk.block().finished.value(), before + 5);
    EXPECT_EQ(o.desk.block().closing.load(), 0u);
    EXPECT_EQ(o.desk.block().released.load(), 0u);
    EXPECT_NO_THROW(Exchange::attach(o.folder / "x"));
    o.step(neckTo(0.4), o.nextSession(), 400);
    EXPECT_NEAR(o.neck(), 0.4, 1e-9) << "run " << run;
  }
}

TEST(LoopHost, RefusesAPeriodThatNoBusCanKeep) {
  for (const Nanos period : {Nanos{0}, Nanos{100us}, Nanos{2s}}) {
    LoopConfig config;
    config.period = period;
    EXPECT_THROW(SimulatedRobot{config}, std::runtime_error);
  }
}

}  // namespace
}  // namespace darwinop::runtime
