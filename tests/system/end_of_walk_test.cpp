// Controllers that end while they walk, as processes: in the twin, over the daemon, and over TCP.
#include <gmock/gmock.h>

#include <csignal>

#include "system/rig.hpp"
#include "system/running_walk.hpp"
#include "system/walk_log.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;

constexpr double kCycleMs = 16;
constexpr double kPeriod = 600 / kCycleMs;  // of the gait, cycles

struct Tolerance {
  WalkLog::Goals goals;
  double longest;  // cycles until it kneels; docs/gait.md: 2900 ms
  double stand;    // cycles in the stance before; docs/gait.md: 400 ms
  double change;   // greatest change of a goal, relative to the walk
};
constexpr Tolerance kSimulated{WalkLog::Goals::kCommanded, 2900 / kCycleMs + 2, 400 / kCycleMs - 1, 1.1};
// A busy machine may take several cycles for a step, send two steps in one, and lose a cycle on the bus.
constexpr Tolerance kBusy{WalkLog::Goals::kAsked, 2 * 2900 / kCycleMs, 200 / kCycleMs, 3};

void expectKneelFromBothFeet(const WalkLog& log, double end_cycle, const Tolerance& tolerance) {
  EXPECT_TRUE(log.kneelsThen());
  EXPECT_GE(log.stood(), tolerance.stand);
  EXPECT_GE(log.lastCycle(), end_cycle);
  EXPECT_LE(log.lastCycle() - end_cycle, tolerance.longest);
  EXPECT_LE(log.greatestChange(tolerance.goals, end_cycle),
            tolerance.change * log.greatestChange(tolerance.goals, end_cycle - 2 * kPeriod, end_cycle));
}

struct Way {
  const char* how;
  const char* ms;  // 150 and 450: on one foot
  int status;
};
class InTheTwin : public Rig, public testing::WithParamInterface<Way> {};

TEST_P(InTheTwin, AWalkThatEndsIsFinished) {
  const auto [how, ms, status] = GetParam();
  Program walk{{program("darwinop-run"), "--robot", "twin", "--record", file("log.csv"), DARWINOP_ENDING_WALK, how, ms},
               file("walk.txt")};
  EXPECT_EQ(walk.wait(seconds{60}), status) << walk.output();
  const std::string said = "ends at ";
  const std::size_t at = walk.output().find(said);
  ASSERT_NE(at, std::string::npos) << walk.output();
  const double end_s = std::strtod(walk.output().c_str() + at + said.size(), nullptr);

  const WalkLog log{file("log.csv")};
  expectKneelFromBothFeet(log, log.firstCycle() + end_s * 1000 / kCycleMs, kSimulated);
  EXPECT_FALSE(log.hasFault(Fault::kFell));
  EXPECT_LT(log.lastTilt(), 0.6) << "sits";
}

INSTANTIATE_TEST_SUITE_P(Ways, InTheTwin,
                         testing::Values(Way{"return", "150", 0}, Way{"exit", "450", 0},
                                         Way{"exception", "150", 128 + SIGABRT}, Way{"SIGINT", "450", 0},
                                         Way{"SIGTERM", "0", 0}),
                         [](const auto& test) { return std::string{test.param.how}; });

class InRealTime : public Rig {};

TEST_F(InRealTime, AWalkThatIsEndedIsFinished) {
  using Link = RunningWalk::Link;
  using Part = RunningWalk::Part;
  const std::vector<RunningWalk::Plan> plans{{Link::kDaemon, Part::kController, SIGINT, 9},
                                             {Link::kDaemon, Part::kController, SIGTERM, 28},
                                             {Link::kTcp, Part::kController, SIGINT, 9},
                                             {Link::kTcp, Part::kServer, SIGTERM, 28},
                                             {Link::kTcp, Part::kDaemon, SIGTERM, 9}};
  // At the same time: most of it is waiting.
  std::vector<std::unique_ptr<RunningWalk>> walks;
  for (const RunningWalk::Plan& plan : plans)
    walks.push_back(std::make_unique<RunningWalk>(plan, file(std::to_string(walks.size()))));
  RunningWalk::runAll(walks);
  for (const auto& walk : walks) {
    SCOPED_TRACE(walk->outputs());
    ASSERT_TRUE(walk->ended());
    expectKneelFromBothFeet(WalkLog{walk->recording()}, walk->endCycle(), kBusy);
  }
}

}  // namespace
}  // namespace darwinop
