// Every shipped experiment loads, is within limits, and completes on the virtual robot in simulated time.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "experiments/run/rig.hpp"

#ifndef DARWINOP_SUITE
#error "tests/experiments/run/CMakeLists.txt names the folder of the experiments"
#endif

namespace darwinop::experiments {
namespace {

std::vector<std::string> suite() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{DARWINOP_SUITE}) names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

TEST(Suite, HasTheTestsOf2013AndThoseForIdentification) {
  for (const char* name : {"speed", "damping", "p_gain", "torque_feedback", "max_torque", "applied_torque", "gyroscope",
                           "accelerometer", "bow_forward", "bow_backward", "slow_triangle", "steps", "multisine",
                           "chirp", "bang", "release", "lift_and_drop"})
    EXPECT_THAT(suite(), testing::Contains(name));
}

class SuiteFile : public testing::TestWithParam<std::string> {
 protected:
  const Experiment experiment = readExperiment(DARWINOP_SUITE "/" + GetParam() + ".ini");
};

TEST_P(SuiteFile, IsWithinLimitsAndNamedAsItsFile) {
  EXPECT_EQ(experiment.name, GetParam());
  const Plan plan = makePlan(experiment, safety::hardRanges());
  EXPECT_LT(plan.seconds(), 180) << "servos heat up";
  EXPECT_FALSE(planText(experiment, plan).empty());
}

TEST_P(SuiteFile, CompletesOnTheVirtualRobotAndReturnsToTheStartPose) {
  VirtualRun run{experiment};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_NEAR(run.position(static_cast<Joint>(i)), startPose()[i], 0.02) << kJointTable[i].name;
  for (const Limit limit : {Limit::kPosition, Limit::kNotFinite, Limit::kSpeed, Limit::kTorque, Limit::kGain})
    EXPECT_EQ(run.limitHits()[static_cast<std::size_t>(limit)], 0U) << "safety corrected a command";
}

INSTANTIATE_TEST_SUITE_P(All, SuiteFile, testing::ValuesIn(suite()), [](const auto& test) { return test.param; });

}  // namespace
}  // namespace darwinop::experiments
