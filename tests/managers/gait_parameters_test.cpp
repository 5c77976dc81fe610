// Gait parameters at run time: checked, applied between two steps.
#include "managers/gait_parameters.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "gait_rig.hpp"
#include "managers/messages.hpp"

namespace darwinop::webots_api {
namespace {

using testing::HasSubstr;
using Parameters = managers::DARwInOPGaitManager::GaitParameters;

using GaitParameters = GaitManager;

TEST_F(GaitParameters, AreThoseOfTheFile) {
  write("[Walking Config]\nperiod_time = 700\nfoot_height = 30\n");
  const Parameters parameters = manager().getParameters();
  EXPECT_EQ(parameters.period_time, 700);
  EXPECT_EQ(parameters.foot_height, 30);
  EXPECT_EQ(parameters.z_offset, Parameters{}.z_offset);
}

TEST_F(GaitParameters, EveryRowOfTheTableWithAnEffectIsPublic) {
  gait::Parameters inside;
  for (const gait::ParameterRow& row : gait::kParameters) inside.*row.field = row.high;
  gait::Parameters back;
  managers::assign(back, managers::publicParameters(inside));
  for (const gait::ParameterRow& row : gait::kParameters)
    if (row.name != "i_gain" && row.name != "d_gain") {
      EXPECT_EQ(back.*row.field, row.high) << row.name;
    }
}

TEST_F(GaitParameters, AWrongValueChangesNothing) {
  const Parameters before = standing().getParameters();
  for (double Parameters::*const field : {&Parameters::period_time, &Parameters::hip_pitch_offset})
    for (const double value : {1e6, -1e6, std::nan("")}) {
      Parameters wrong = before;
      wrong.foot_height = 25;
      wrong.*field = value;
      forgetWarnings();
      testing::internal::CaptureStderr();
      EXPECT_FALSE(manager().setParameters(wrong));
      EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(managers::messages::kParametersRefused));
      EXPECT_EQ(manager().getParameters().foot_height, before.foot_height);
    }
  testing::internal::CaptureStderr();
  managers::DARwInOPGaitManager without_robot{nullptr, ini()};
  EXPECT_FALSE(without_robot.setParameters(before));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(managers::messages::kNotInitialized));
}

TEST_F(GaitParameters, ApplyWhenBothFeetAreDown) {
  standing().start();
  steps(10);  // 160 ms: the left foot is in the air until 285 ms
  gait::Engine unchanged{gait::shipped()};
  unchanged.start();
  for (int call = 0; call < 20; ++call) unchanged.next({}, {NAN, NAN});
  Parameters changed = manager().getParameters();
  changed.period_time = 720;
  changed.hip_pitch_offset = 14;
  EXPECT_TRUE(manager().setParameters(changed));
  EXPECT_EQ(manager().getParameters().period_time, 720);
  for (int step = 10; step < 18; ++step) {
    steps(1);
    unchanged.next({}, {NAN, NAN});
    ASSERT_EQ(goals(), unchanged.next({}, {NAN, NAN}).tick) << step;
  }
  steps(2);
  unchanged.next({}, {NAN, NAN});
  EXPECT_NE(goals(), unchanged.next({}, {NAN, NAN}).tick);
  steps(60);
  const auto there = goals();
  steps(20);
  EXPECT_NE(goals(), there);
  steps(25);
  EXPECT_EQ(goals(), there) << "a period of 720 ms";
}

TEST_F(GaitParameters, GainsReachTheJointsDuringAWalk) {
  standing().start();
  steps(5);
  Parameters changed = manager().getParameters();
  changed.p_gain = 48;
  manager().setParameters(changed);
  steps(40);
  EXPECT_EQ(fake.last().joint[index(Joint::kLegLowerR)].p_gain, 6);
}

TEST_F(GaitParameters, AtRestTheyChangeTheStanceOfTheNextStart) {
  Parameters changed = standing().getParameters();
  changed.z_offset = 30;
  manager().setParameters(changed);
  gait::Parameters lower = gait::shipped();
  lower.z_offset = 30;
  manager().start();
  steps(1);
  for (std::size_t i = 0; i < kWalking; ++i) EXPECT_NEAR(goals()[i], gait::kStanding.tick[i], 12) << "slowly";
  manager().stop();
  EXPECT_EQ(goals(), gait::Engine{lower}.goals().tick);
}

TEST_F(GaitParameters, ACopyHasThem) {
  Parameters changed = manager().getParameters();
  changed.foot_height = 33;
  manager().setParameters(changed);
  const managers::DARwInOPGaitManager copy{manager()};
  EXPECT_EQ(copy.getParameters().foot_height, 33);
}

}  // namespace
}  // namespace darwinop::webots_api
