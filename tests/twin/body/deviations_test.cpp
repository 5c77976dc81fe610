// What a model file changes in the body: masses of links, soles, slope of the floor, sensors' filter and delay,
// battery.
#include <cmath>
#include <limits>

#include "twin/body/link_inertia.hpp"
#include "twin/body/placing.hpp"
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

/// The shipped body with these lines in the model file; its line 1 is "[model]".
Model modelOf(const std::string& lines) {
  return parseModel("[model]\nname = test\n[body]\ntrunk_com = manufacturer\n" + lines, DARWINOP_MODELS "/my.ini");
}
RobotBody robot(const std::string& lines) {
  return RobotBody{modelOf(lines), {.ball = Ball::kNone}};
}
std::string refusal(const std::string& lines) {
  try {
    robot(lines);
  } catch (const std::runtime_error& wrong) {
    return wrong.what();
  }
  return {};
}

TEST(LinkOfAModel, HasAnAddedMassAtItsPlaceFromTheCentreOfMass) {
  RobotBody plain = robot(""), changed = robot("[link ArmLowerR]\nmass = 0.055 kg\nmass_from_com = 0.02, 0, -0.03 m\n");
  const int arm = idOf(plain, mjOBJ_BODY, "ArmLowerR");
  const LinkInertia was = inertiaOfLink(*plain.mujocoModel(), arm), now = inertiaOfLink(*changed.mujocoModel(), arm);
  EXPECT_NEAR(now.mass_kg, was.mass_kg + 0.055, 1e-12);
  const double share = 0.055 / now.mass_kg;
  EXPECT_NEAR(now.com_m.x(), was.com_m.x() + share * 0.02, 1e-12);
  EXPECT_NEAR(now.com_m.z(), was.com_m.z() - share * 0.03, 1e-12);
  // About y by the reduced mass of the two.
  const double added = was.mass_kg * share * (0.02 * 0.02 + 0.03 * 0.03);
  EXPECT_NEAR(now.inertia_kgm2(1, 1), was.inertia_kgm2(1, 1) + added, 1e-9);
  EXPECT_EQ(changed.mujocoModel()->body_mass[idOf(plain, mjOBJ_BODY, "ArmLowerL")], was.mass_kg);
}

TEST(LinkOfAModel, OfTheTrunkIsCalledBodyAndItsCentreOfMassMoves) {
  RobotBody plain = robot(""), changed = robot("[link Body]\ncom_shift = 0, 0, -0.018 m\n");
  const int trunk = idOf(plain, mjOBJ_BODY, "Body");
  const mjtNum *was = plain.mujocoModel()->body_ipos + 3 * trunk, *now = changed.mujocoModel()->body_ipos + 3 * trunk;
  EXPECT_NEAR(now[2], was[2] - 0.018, 1e-12);
  EXPECT_NEAR(now[1], was[1], 1e-12);
}

TEST(LinkOfAModel, ThatCannotExistIsRefusedWithFileLineAndKey) {
  EXPECT_EQ(refusal("[link ArmLowerR]\ncom_shift = 0, 0, 0.01 m\nmass = -0.2 kg\n")
                .find(DARWINOP_MODELS "/my.ini, line 7: [link ArmLowerR] mass"),
            0u)
      << refusal("[link ArmLowerR]\ncom_shift = 0, 0, 0.01 m\nmass = -0.2 kg\n");
  EXPECT_NE(refusal("[link ArmLowerQ]\nmass = 0.1 kg\n").find("line 5: there is no link \"ArmLowerQ\"; did you mean"),
            std::string::npos)
      << refusal("[link ArmLowerQ]\nmass = 0.1 kg\n");
}

TEST(Soles, OfAModelKeepTheirThickness) {
  RobotBody plain = robot(""), small = robot("sole_size = 0.7\n");
  const mjModel &was = *plain.mujocoModel(), &now = *small.mujocoModel();
  int changed = 0;
  for (int g = 0; g < was.ngeom; ++g) {
    if (was.geom_contype[g] == 0 || was.geom_size[3 * g] == now.geom_size[3 * g]) continue;
    ++changed;
    EXPECT_NEAR(now.geom_size[3 * g], 0.7 * was.geom_size[3 * g], 1e-12);
    EXPECT_EQ(now.geom_size[3 * g + 1], was.geom_size[3 * g + 1]);
    EXPECT_NEAR(now.geom_size[3 * g + 2], 0.7 * was.geom_size[3 * g + 2], 1e-12);
  }
  EXPECT_EQ(changed, 2);
}

// Turned about x (forward), the floor rises to the left, and a standing robot's accelerometer (right, forward, up)
// reads as one that is rolled.
TEST(FloorOfAModel, TiltedIsFeltByTheStandingRobotAndNotInAStand) {
  RobotBody standing = robot("floor_tilt_x = 0.05 rad\n");
  run(standing, holding(startPose()), 0.5);
  RobotBody level = robot("");
  run(level, holding(startPose()), 0.5);
  const double tilt = standing.state().accel_m_s2[0] - level.state().accel_m_s2[0];
  EXPECT_NEAR(std::abs(tilt), kGravity * std::sin(0.05), 0.05);
  RobotBody held{modelOf("floor_tilt_x = 0.05 rad\n"), {.ball = Ball::kNone, .clamped_up = ClampedUp{0, 1, 0}}};
  run(held, limp(), 0.1);
  EXPECT_NEAR(held.state().accel_m_s2[0], 0, 1e-3);
  EXPECT_NEAR(held.state().accel_m_s2[2], kGravity, 1e-3);
}

/// Rate that the gyroscope reads about its z `cycles` after the trunk began to spin about the vertical at 1 rad/s.
double spinRead(const std::string& lines, int cycles) {
  RobotBody body = robot(lines);
  lift(body);
  run(body, limp(), 0.05);
  trunkQvel(body)[4] = 1;  // about the trunk's y, up
  for (int i = 0; i < cycles; ++i) body.step(kStep, limp());
  return body.state().gyro_rad_s[2];
}

TEST(GyroscopeOfAModel, WithADelayReadsAsAnotherDidBefore) {
  const double now = spinRead("", 20);
  ASSERT_GT(now, 0.5);
  EXPECT_NEAR(spinRead("[imu]\ndelay = 0.02 s\n", 40), now, 1e-9);
  EXPECT_NEAR(spinRead("[imu]\ndelay = 0.02 s\n", 15), 0, 0.05);
}

TEST(GyroscopeOfAModel, WithAFilterFollowsByItsTimeConstant) {
  EXPECT_NEAR(spinRead("[imu]\ngyro_lowpass = 0.03 s\n", 30) / spinRead("", 15), 1 - std::exp(-1), 0.03);
}

TEST(GyroscopeOfAModel, WithOtherAxesReadsThem) {
  const double straight = spinRead("", 20);
  RobotBody body = robot("[imu]\ngyro_axes = -3, 2, 1\n");
  lift(body);
  run(body, limp(), 0.05);
  trunkQvel(body)[4] = 1;
  run(body, limp(), 0.02);
  EXPECT_NEAR(body.state().gyro_rad_s[0], -straight, 1e-9);
}

// All servos share the voltage: it falls by the resistance times the current that they draw together.
TEST(BatteryOfAModel, SagsByTheCurrentOfAllServos) {
  RobotBody body{modelOf("battery_resistance = 0.3 ohm\n"), {.ball = Ball::kNone, .clamped_up = ClampedUp{0, 1, 0}}};
  const Pose far = [] {
    Pose pose = startPose();
    for (double& angle : pose) angle += 0.15;
    return pose;
  }();
  run(body, holding(far), 0.02);
  const double drop = body.state().battery_drop_v;
  EXPECT_GT(drop, 0.5);
  for (const JointMotion& joint : body.state().joint) EXPECT_NEAR(joint.supply_v, 12 - drop, 1e-9);
  RobotBody stiff{modelOf(""), {.ball = Ball::kNone, .clamped_up = ClampedUp{0, 1, 0}}};
  run(stiff, holding(far), 0.02);
  EXPECT_EQ(stiff.state().battery_drop_v, 0);
}

TEST(BatteryOfAModel, LeavesAnUnknownSupplyUnknown) {
  RobotBody body{modelOf("battery_resistance = 0.3 ohm\n"), {.ball = Ball::kNone, .clamped_up = ClampedUp{0, 1, 0}}};
  Drives drives = limp();  // without torque, the supply moves nothing
  for (ServoDrive& drive : drives) drive.supply_v = std::numeric_limits<double>::quiet_NaN();
  run(body, drives, 0.01);
  for (const JointMotion& joint : body.state().joint) EXPECT_TRUE(std::isnan(joint.supply_v));
}

TEST(BatteryOfAModel, DoesNotOscillateAtFullLoad) {
  RobotBody body{modelOf("battery_resistance = 1.5 ohm\n"), {.ball = Ball::kNone, .clamped_up = ClampedUp{0, 1, 0}}};
  Pose far = startPose();
  for (double& angle : far) angle += 1.5;
  run(body, holding(far, 16), 0.01);
  const double before = body.state().battery_drop_v;
  run(body, holding(far, 16), 0.001);
  EXPECT_NEAR(body.state().battery_drop_v, before, 0.3);
  EXPECT_LT(before, 12);
}

}  // namespace
}  // namespace darwinop::twin::test
