// A whole loop in simulated time: what a controller sees, what an operator can do, what is left behind.
#include <gmock/gmock.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "environment.hpp"
#include "runtime/operator.hpp"
#include "runtime/report.hpp"
#include "simulated_robot.hpp"
#include "support/temporary_folder.hpp"

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
    std::ifstream file{config.record_path};
    std::stringstream all;
    all << file.rdbuf();
    run = std::regex_replace(all.str(), std::regex{"# date: .*"}, "");
  }
  EXPECT_EQ(text[0], text[1]);
  EXPECT_GT(std::count(text[0].begin(), text[0].end(), '\n'), 700) << "more cycles than the ring holds, none lost";
  EXPECT_THAT(text[0], testing::Not(HasSubstr("lost rows")));
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
  const Exchange left = Exchange::attach(folder / "x");
  StatsView stats;
  left.block().stats.copyTo(stats);
  Sensors last;
  ASSERT_TRUE(left.block().sensors.read(last));
  EXPECT_EQ(stats.cycles, 23u) << "20 and three for the farewell";
  EXPECT_THAT(reportText(stats, last), HasSubstr("FootL"));
  EXPECT_EQ(Nanos{left.block().info.period_ns}, 16ms);
}

struct Operated {
  TemporaryFolder folder;
  Environment environment{"DARWINOP_EXCHANGE", folder / "x"};
  SimulatedRobot sim;
  Exchange desk = Exchange::attach(folder / "x");
};

TEST(Operator, ReleaseTakesAllTorqueAwayAndHoldsWhateverTheControllerDoes) {
  Operated o;
  o.sim.step(neckTo(0.5), 300);
  ASSERT_FALSE(o.sim.limp());
  o.desk.block().released.store(o.desk.block().session.fetch_add(1) + 1);
  o.sim.step(neckTo(0.5), 10);
  EXPECT_TRUE(o.sim.limp());
  o.sim.step(neckTo(-0.5), 2000);
  EXPECT_TRUE(o.sim.limp());
  EXPECT_EQ(o.sim.link->sensors().safety.worst, Fault::kNone) << "the operator is there and stays";
  EXPECT_NEAR(o.sim.robot->position[index(Joint::kNeck)].value, 0.5, 1e-9);
}

TEST(Lockstep, AControllerThatNeverDroveDoesNotEndTheSessionOfAnother) {
  Operated o;
  Commands other = neckTo(0.5);
  other.session = 7;
  for (; other.sequence < 300; ++other.sequence) {
    o.desk.block().commands.publish(other);
    (void)o.sim.link->waitForCycle(o.sim.link->sensors().cycle + 1, o.sim.stop);
  }
  ASSERT_FALSE(o.sim.limp());
  o.sim.link.reset();
  EXPECT_FALSE(o.sim.limp());
}

TEST(Operator, AfterAReleaseTheNextSessionTakesOver) {
  Operated o;
  o.sim.step(neckTo(0.5), 300);
  o.desk.block().released.store(o.desk.block().session.fetch_add(1) + 1);
  o.sim.step(neckTo(0.5), 10);
  Commands next = neckTo(0.4);
  next.session = o.desk.block().session.fetch_add(1) + 1;
  for (std::uint64_t i = 0; i < 300; ++i) {
    next.sequence = i;
    o.desk.block().commands.publish(next);
    (void)o.sim.link->waitForCycle(o.sim.link->sensors().cycle + 1, o.sim.stop);
  }
  EXPECT_FALSE(o.sim.limp());
  EXPECT_NEAR(o.sim.robot->position[index(Joint::kNeck)].value, 0.4, 1e-9);
}

TEST(Operator, ClosingTheLoopBringsTheRobotToRestEvenWithAControllerThatGoesOn) {
  Operated o;
  o.sim.step(neckTo(0.5), 300);
  o.desk.block().closing.store(1);
  o.sim.step(neckTo(0.5), 400);
  EXPECT_TRUE(o.sim.limp());
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
