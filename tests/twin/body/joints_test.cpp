// Joints under servos: friction that holds without creeping, both laws, other firmware periods, soft gears.
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

// A hanging robot, its right arm stretched sideways: the weight pulls at the shoulder's roll joint.
Pose armOut() {
  Pose angles{};
  angles[index(Joint::kArmUpperR)] = 0.8;
  return angles;
}

TEST(DryFriction, HoldsALoadBelowItWithoutCreeping) {
  for (const double friction : {0.25, 1.0}) {
    RobotBody body{modelWith(friction), {.ball = Ball::kNone}};
    hangUp(body, armOut());
    run(body, limp(), 0.5);  // the first shock is over
    const double before = angleOf(body, Joint::kArmUpperR);
    EXPECT_NEAR(before, 0.8, 0.1 * kRadPerTick);
    run(body, limp(), 10);
    EXPECT_NEAR(angleOf(body, Joint::kArmUpperR), before, 0.01 * kRadPerTick) << friction;
  }
}

TEST(DryFriction, LetsGoOfALoadAboveIt) {
  RobotBody body{modelWith(0.05), {.ball = Ball::kNone}};
  hangUp(body, armOut());
  run(body, limp(), 1);
  EXPECT_LT(angleOf(body, Joint::kArmUpperR), 0.4);
}

TEST(DryFriction, NeverAddsEnergy) {
  RobotBody body{modelWith(0.02), {.ball = Ball::kNone}};
  hangUp(body, armOut());
  mjData& d = *body.mujocoData();
  double speed = 0;
  for (int i = 0; i < 4000; ++i) {
    body.step(kStep, limp());
    if (i >= 3900) speed = std::max(speed, std::abs(d.qvel[dofOf(body, Joint::kArmUpperR)]));
  }
  EXPECT_LT(speed, 1e-4);  // at rest, all of it
}

// Where the arm comes to rest when it is told to go up, from hanging.
double armAfter(const Model& model, double p_gain, double seconds = 3) {
  RobotBody body{model, {.ball = Ball::kNone}};
  Pose down{};
  down[index(Joint::kArmUpperR)] = -0.6;
  hangUp(body, down);
  Drives drives = holding(down);
  drives[index(Joint::kArmUpperR)].goal_rad = 0.8;
  drives[index(Joint::kArmUpperR)].p_gain = p_gain;
  run(body, drives, seconds);
  return angleOf(body, Joint::kArmUpperR);
}

TEST(LawSpeedP, ReachesItsGoalWhateverPIs) {
  Model model = modelWith(0.025, 0.002);
  model.servo.law = Law::kSpeedP;
  model.servo.accel_max_rad_s2 = 55;
  EXPECT_NEAR(armAfter(model, 10), 0.8, 2 * kRadPerTick);
  EXPECT_NEAR(armAfter(model, 1, 10), 0.8, 2 * kRadPerTick);  // P is 1/s here: ten times its time constant
  model.servo.armature_kgm2 = 0;                              // as the simulator of 2013
  EXPECT_NEAR(armAfter(model, 4), 0.8, 2 * kRadPerTick);
}

TEST(LawSpeedP, ReportsTheTorqueThatTheArmAsksFor) {
  Model model = modelWith();
  model.servo.law = Law::kSpeedP;
  RobotBody body{model, {.ball = Ball::kNone}};
  hangUp(body, armOut());
  run(body, holding(armOut()), 1);
  mjData& d = *body.mujocoData();
  mj_forward(body.mujocoModel(), &d);
  const double gravity_nm = d.qfrc_bias[dofOf(body, Joint::kArmUpperR)];
  EXPECT_GT(gravity_nm, 0.1);  // pulls down, the motor pushes up
  EXPECT_NEAR(body.state().joint[index(Joint::kArmUpperR)].load * 2.5, gravity_nm, 0.05 * gravity_nm);
}

TEST(LawSpeedP, ReportsNoTorqueOnceItMayUseNone) {
  Model model = modelWith();
  model.servo.law = Law::kSpeedP;
  RobotBody body{model, {.ball = Ball::kNone}};
  hangUp(body, armOut());
  Drives drives = holding(armOut());
  run(body, drives, 1);
  const double before = body.state().joint[index(Joint::kArmUpperR)].load;
  for (ServoDrive& drive : drives) drive.torque_limit = 0;
  run(body, drives, 0.1);  // twenty time constants of the reported load
  EXPECT_GT(std::abs(before), 0.02);
  EXPECT_NEAR(body.state().joint[index(Joint::kArmUpperR)].load, 0, 1e-6);
}

TEST(LawVoltageP, StopsShortUnderLoadAndLessSoWithMoreP) {
  const double soft = armAfter(modelWith(), 1), normal = armAfter(modelWith(), 4), hard = armAfter(modelWith(), 16);
  EXPECT_LT(soft, 0.8 - 0.02);
  EXPECT_LT(soft, normal);
  EXPECT_LT(normal, hard);
  EXPECT_LE(hard, 0.8 + kRadPerTick);
}

TEST(Firmware, MayBeFasterOrSlowerThanThePhysics) {
  const double usual = armAfter(modelWith(0.02), 4);
  for (const double period : {0.0005, 0.004}) {
    Model model = modelWith(0.02);
    model.servo.firmware_period_s = period;
    EXPECT_NEAR(armAfter(model, 4), usual, 5 * kRadPerTick) << period;
  }
}

TEST(SoftGear, PlayLetsTheArmHangByUpToItsWidth) {
  const EffectInfo* backlash = findEffect("backlash");
  ASSERT_NE(backlash, nullptr);
  std::vector<double> values;
  for (const Parameter& parameter : backlash->parameters) values.push_back(parameter.neutral);
  values[0] = 0.02;
  Model model = modelWith(0.02, 0.01);
  model.effects.push_back({backlash, values, {}});
  const double rigid = armAfter(modelWith(0.02, 0.01), 4), soft = armAfter(model, 4);
  // The arm hangs down by half its play at most, and the servo holds the middle.
  EXPECT_LT(soft, rigid + kRadPerTick);
  EXPECT_GT(soft, rigid - 0.015);
}

TEST(Goals, ThatAreNoNumbersDoNotBreakTheBody) {
  RobotBody body{modelWith(0.05)};
  Drives drives = holding(Pose{});
  for (ServoDrive& drive : drives) drive.goal_rad = std::numeric_limits<double>::quiet_NaN();
  run(body, drives, 0.1);
  run(body, holding(Pose{}), 0.1);
  for (const double place : body.trunkPosition()) EXPECT_TRUE(std::isfinite(place));
}

}  // namespace
}  // namespace darwinop::twin::test
