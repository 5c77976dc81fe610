// End of a run: stop request, fall, lost robot; always with a slow return where possible.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/format/texts.hpp"
#include "experiments/run/rig.hpp"

namespace darwinop::experiments {
namespace {

/// Maximum speed of any goal, rad/s.
double fastestGoal(const VirtualRun& run) {
  double most = 0;
  for (std::size_t i = 1; i < run.rows.size(); ++i)
    for (std::size_t j = 0; j < kJoints; ++j)
      if (run.rows[i].asked.joint[j].has(JointCommand::kGoal) &&
          run.rows[i - 1].asked.joint[j].has(JointCommand::kGoal))
        most = std::max(
            most, std::abs(run.rows[i].asked.joint[j].goal.value - run.rows[i - 1].asked.joint[j].goal.value) / 0.016);
  return most;
}

TEST(Run, StopReturnsTheRobotSlowly) {
  const std::string standing = with(with(kNod, "pose = start\nduration = 1 s", "pose = standing\nduration = 4 s"),
                                    "duration = 1 s\n[record]", "duration = 60 s\n[record]");
  VirtualRun run{parseExperiment(standing, "my.ini")};
  run.on_step = [&](const std::string& name, double seconds) {
    run.stop = run.stop || (name == "turn" && seconds > 5);
  };
  EXPECT_EQ(run.run(), RunOutcome::kStopped);
  EXPECT_LT(run.secondsOf(run.rowsOf("turn")), 1.1) << "not the whole minute";
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_NEAR(run.position(static_cast<Joint>(i)), startPose()[i], 0.02) << kJointTable[i].name;
}

TEST(Run, StopDuringSetupReturnsTheRobot) {
  const std::string standing = with(kNod, "pose = start\nduration = 1 s", "pose = standing\nduration = 4 s");
  VirtualRun run{parseExperiment(standing, "my.ini")};
  run.on_step = [&](const std::string&, double seconds) { run.stop = run.stop || seconds > 2; };
  EXPECT_EQ(run.run(), RunOutcome::kStopped);
  EXPECT_TRUE(run.rowsOf("turn").empty());
  EXPECT_LT(fastestGoal(run), kSetupMost);
  EXPECT_NEAR(run.position(Joint::kLegLowerR), startPose()[index(Joint::kLegLowerR)], 0.02);
}

TEST(Run, FallDuringSetupSkipsAllPhases) {
  VirtualRun run{phase(kStep)};
  run.on_step = [&](const std::string&, double seconds) {
    if (seconds > 0.3)
      run.bend = [](Sensors& seen) {
        seen.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{-9.81}, MeterPerSec2{0}};
      };
  };
  EXPECT_EQ(run.run(), RunOutcome::kFell);
  EXPECT_TRUE(run.rowsOf("turn").empty());
}

TEST(Run, FallEndsAPhaseWithUntilFallen) {
  VirtualRun run{phase(kStep + "until = fallen\n")};
  run.on_step = [&](const std::string& name, double) {
    if (name == "turn")
      run.bend = [](Sensors& seen) {
        seen.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{-9.81}, MeterPerSec2{0}};
      };
  };
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  EXPECT_NEAR(run.secondsOf(run.rowsOf("turn")), 0.25, 0.05) << "not the whole second";
}

TEST(Run, EndsWithTheRobot) {
  VirtualRun run{phase(kStep)};
  int steps_after = 0;
  run.on_step = [&](const std::string& name, double) {
    if (name == "turn") run.end();
    if (name == "turn" && ++steps_after > 500) throw std::runtime_error("it goes on without a robot");
  };
  EXPECT_EQ(run.run(), RunOutcome::kEnded);
  EXPECT_LE(steps_after, 1);
}

}  // namespace
}  // namespace darwinop::experiments
