// Every delivered experiment loads, stays within limits, and runs to its end on the virtual robot in simulated time.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "experiments/run/rig.hpp"

#ifndef DARWINOP_BATTERY
#error "tests/experiments/run/CMakeLists.txt names the folder of the experiments"
#endif

namespace darwinop::experiments {
namespace {

std::vector<std::string> battery() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{DARWINOP_BATTERY}) names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

TEST(Battery, HasTheSeedsTestsAndThoseForIdentification) {
  for (const char* name : {"speed", "damping", "p_gain", "torque_feedback", "max_torque", "applied_torque", "gyroscope",
                           "accelerometer", "bow_forward", "bow_backward", "slow_triangle", "steps", "multisine",
                           "chirp", "bang", "release", "lift_and_drop"})
    EXPECT_THAT(battery(), testing::Contains(name));
}

class BatteryFile : public testing::TestWithParam<std::string> {
 protected:
  const Experiment experiment = readExperiment(DARWINOP_BATTERY "/" + GetParam() + ".ini");
};

TEST_P(BatteryFile, IsWithinLimitsAndNamedAsItsFile) {
  EXPECT_EQ(experiment.name, GetParam());
  const Plan plan = makePlan(experiment, safety::hardRanges());
  EXPECT_LT(plan.seconds(), 180) << "servos get warm";
  EXPECT_FALSE(planText(experiment, plan).empty());
}

TEST_P(BatteryFile, RunsToItsEndOnTheVirtualRobotAndSitsDown) {
  VirtualRun run{experiment};
  EXPECT_EQ(run.run(), Outcome::kDone);
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_NEAR(run.position(static_cast<Joint>(i)), startPose()[i], 0.02) << kJointTable[i].name;
  for (const Limit limit : {Limit::kPosition, Limit::kNotFinite, Limit::kSpeed, Limit::kTorque, Limit::kGain})
    EXPECT_EQ(run.limitHits()[static_cast<std::size_t>(limit)], 0U) << "safety had to correct what was asked for";
}

INSTANTIATE_TEST_SUITE_P(All, BatteryFile, testing::ValuesIn(battery()), [](const auto& test) { return test.param; });

}  // namespace
}  // namespace darwinop::experiments
