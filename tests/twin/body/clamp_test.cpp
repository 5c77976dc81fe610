// A trunk in a stand: where it is, what its sensors read, and that its joints move as under gravity alone.
#include "runtime/environment.hpp"
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

const Pose kArmsOut = [] {
  Pose pose{};
  pose[index(Joint::kArmUpperR)] = 0.4, pose[index(Joint::kArmUpperL)] = -0.4;
  return pose;
}();

TEST(Clamp, TheAccelerometerReadsGravityAlongUpAndTheGyroscopeNothing) {
  // Trunk: left, up, forward. Sensor: right, forward, up.
  const std::vector<std::pair<Vec, Vec>> cases{{{0, 1, 0}, {0, 0, kGravity}},
                                               {{-1, 0, 0}, {kGravity, 0, 0}},
                                               {{0, 0, -1}, {0, -kGravity, 0}},
                                               {{0, -1, 0}, {0, 0, -kGravity}}};
  for (const auto& [up, reading] : cases) {
    RobotBody body{modelWith(0.03), {.clamped_up = up}};
    Pose moved = kArmsOut;
    moved[index(Joint::kLegUpperR)] = -0.6;
    run(body, holding(moved), 0.3);  // limbs in full motion
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(body.state().accel_m_s2[i], reading[i], 1e-6);
      EXPECT_NEAR(body.state().gyro_rad_s[i], 0, 1e-9);
    }
  }
}

TEST(Clamp, AJointAtRestDoesNotCreep) {
  RobotBody body{modelWith(0.2), {.clamped_up = Vec{0, 1, 0}}};
  body.place(kArmsOut);
  run(body, holding(kArmsOut), 1);
  const double before = body.mujocoData()->qpos[body.mujocoModel()->jnt_qposadr[idOf(body, mjOBJ_JOINT, "ArmUpperR")]];
  run(body, holding(kArmsOut), 10);
  const double after = body.mujocoData()->qpos[body.mujocoModel()->jnt_qposadr[idOf(body, mjOBJ_JOINT, "ArmUpperR")]];
  EXPECT_NEAR(after, before, 1e-4);
}

TEST(Clamp, ALimpArmSwingsToWhereGravityPullsIt) {
  // Face down and face up.
  const auto settled = [](const Vec& up) {
    RobotBody body{modelWith(0.003, 0.01), {.clamped_up = up}};
    body.place(Pose{});
    run(body, limp(), 4);
    return body.state().joint[index(Joint::kShoulderR)].position_rad;
  };
  EXPECT_GT(std::abs(settled({0, 0, 1}) - settled({0, 0, -1})), 1);
}

TEST(Clamp, TurnsTheRobotWhileItRuns) {
  RobotBody body{modelWith()};
  run(body, limp(), 0.1);
  for (const Vec& up : {Vec{-0.6, 0, 0.8}, Vec{0, 1, 0}}) {
    ASSERT_TRUE(body.clamp(up));
    run(body, holding(kArmsOut), 0.3);
    Vec seen{};
    const Vec vertical{0, 0, 1};
    mju_rotVecMatT(seen.data(), vertical.data(), body.mujocoData()->xmat + 9 * idOf(body, mjOBJ_BODY, "Body"));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], up[k], 1e-9);
  }
}

TEST(Mounting, TurnsTheBoardInTheTrunk) {
  constexpr double kTenth = 0.1;  // rad
  Model model = modelWith();
  model.imu.mounting_rad = {0, 0, kTenth};  // about forward: its up leans to the right
  const RobotBody body{model, {.clamped_up = Vec{0, 1, 0}}};
  EXPECT_NEAR(body.state().accel_m_s2[0], -kGravity * std::sin(kTenth), 0.001);
  EXPECT_NEAR(body.state().accel_m_s2[1], 0, 0.001);
  EXPECT_NEAR(body.state().accel_m_s2[2], kGravity * std::cos(kTenth), 0.001);
}

TEST(Clamp, TheVariableIsADirectionOfAnyLengthOrAnError) {
  const auto read = [](const char* text) {
    const runtime::Environment clamp{"DARWINOP_TWIN_CLAMP", text};
    return clampFromEnvironment();
  };
  EXPECT_FALSE(read("").has_value());
  EXPECT_EQ(read("0 0 -3").value(), (ClampedUp{0, 0, -1}));
  for (const char* const wrong : {"0 1", "0 0 0", "up", "0 1 0 2", "nan 0 1"})
    EXPECT_THROW((void)read(wrong), std::runtime_error) << wrong;
}

}  // namespace
}  // namespace darwinop::twin::test
