// On the floor: tipping over, slipping, being pushed; the ball; the robot against itself.
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

TEST(StartPose, StandsAsHighAsInTheWorldsOf2013) {
  RobotBody body{modelWith()};
  EXPECT_NEAR(body.trunkPosition()[2], 0.237, 0.005);  // 0.236 to 0.24 m there, above the floor
}

// A stiff robot, all joints at zero, on a floor that leans: it tips when its centre of mass passes the edge of the
// soles. Centre of mass 227.7 mm high and 2.9 mm behind the middle of soles of 105 mm (manufacturer's trunk).
bool stands(double slope_rad) {
  RobotBody body{modelWith(50)};
  body.place(Pose{});
  mjModel& m = bend(body);
  for (int i = 0; i < 3000; ++i) {
    const double now = slope_rad * std::min(1.0, i / 1000.0);
    m.opt.gravity[0] = kGravity * std::sin(now);
    m.opt.gravity[2] = -kGravity * std::cos(now);
    body.step(kStep, limp());
  }
  return body.upright() > 0.9;
}

TEST(StandingStraight, TipsOverAtTheAngleOfItsGeometry) {
  const double forward = std::atan((52.5 + 2.9) / 227.7), backward = std::atan((52.5 - 2.9) / 227.7);
  // The floor gives way by a fraction of a millimetre over 105 mm: half a degree.
  const double play = 0.6 * kRadPerDegree;
  EXPECT_TRUE(stands(forward - play));
  EXPECT_FALSE(stands(forward + play));
  EXPECT_TRUE(stands(-backward + play));
  EXPECT_FALSE(stands(-backward - play));
}

TEST(Floor, LetsFeetSlipWhereItIsSmooth) {
  const auto slides = [](double friction) {
    Model model = modelWith(50);
    model.body.floor_friction = friction;
    RobotBody body{model};
    body.place(Pose{});
    bend(body).opt.gravity[0] = kGravity * std::tan(6 * kRadPerDegree);  // a slope of 6 degrees: 0.105
    run(body, limp(), 1);
    return body.trunkPosition()[0];
  };
  EXPECT_LT(slides(0.2), 0.01);  // leans, no more
  EXPECT_GT(slides(0.05), 0.1);
}

TEST(Push, MovesTheTrunkTheWayItPoints) {
  RobotBody body{modelWith(0.05)};
  body.place(Pose{});
  run(body, holding(Pose{}), 1);
  body.push({20, 0, 0}, std::chrono::milliseconds{300});
  run(body, holding(Pose{}), 2);
  EXPECT_LT(body.upright(), 0.5);  // 20 N, two thirds of its weight
  EXPECT_GT(body.trunkPosition()[0], 0.1);
}

TEST(Ball, LiesWhereItIsPutAndRollsWhenHit) {
  RobotBody body{modelWith(50)};
  body.placeBall(0.4, -0.2);
  run(body, limp(), 1);
  const mjModel& m = *body.mujocoModel();
  const int at = m.jnt_qposadr[idOf(body, mjOBJ_JOINT, "ball")], dof = m.jnt_dofadr[idOf(body, mjOBJ_JOINT, "ball")];
  mjData& d = *body.mujocoData();
  EXPECT_NEAR(d.qpos[at], 0.4, 1e-3);
  EXPECT_NEAR(d.qpos[at + 1], -0.2, 1e-3);
  EXPECT_NEAR(d.qpos[at + 2], m.geom_size[3 * idOf(body, mjOBJ_GEOM, "ball")], 1e-3);
  d.qvel[dof] = 0.5;
  run(body, limp(), 1);
  EXPECT_GT(d.qpos[at], 0.6);
  run(body, limp(), 20);
  EXPECT_LT(std::abs(d.qvel[dof]), 0.05);  // rolling friction ends it
}

TEST(Ball, IsNotThereWhenNotWanted) {
  RobotBody body{modelWith(), {.ball = Ball::kNone}};
  EXPECT_EQ(mj_name2id(body.mujocoModel(), mjOBJ_BODY, "ball"), -1);
  body.placeBall(1, 1);  // and nobody minds
  EXPECT_EQ(body.mujocoModel()->nv, 26);
}

// Counts contacts of the robot with itself at a pose.
int selfContacts(RobotBody& body) {
  const mjModel& m = *body.mujocoModel();
  const mjData& d = *body.mujocoData();
  const int trunk = idOf(body, mjOBJ_BODY, "Body");
  int count = 0;
  for (int c = 0; c < d.ncon; ++c)
    count += m.body_rootid[m.geom_bodyid[d.contact[c].geom1]] == trunk &&
             m.body_rootid[m.geom_bodyid[d.contact[c].geom2]] == trunk;
  return count;
}

TEST(SelfCollision, IsOnlyWhereLimbsReallyMeet) {
  Pose arm_in_chest{};
  arm_in_chest[index(Joint::kArmUpperL)] = 0.76;
  arm_in_chest[index(Joint::kShoulderL)] = -0.5;
  arm_in_chest[index(Joint::kArmUpperR)] = -0.67;
  arm_in_chest[index(Joint::kArmLowerR)] = 1.1;
  Pose knees{};
  knees[index(Joint::kPelvL)] = -0.9;
  knees[index(Joint::kPelvR)] = 0.9;
  Pose crossed{};
  crossed[index(Joint::kPelvR)] = -0.4;
  crossed[index(Joint::kPelvL)] = 0.4;
  for (const bool on : {false, true}) {
    Model model = modelWith();
    model.body.self_collision = on;
    RobotBody body{model};
    mj_forward(body.mujocoModel(), body.mujocoData());
    EXPECT_EQ(selfContacts(body), 0) << "start pose";
    for (const Pose& free : {Pose{}, knees}) {
      body.place(free);
      pose(body, free);
      EXPECT_EQ(selfContacts(body), 0);
    }
    pose(body, crossed);
    EXPECT_EQ(selfContacts(body) > 0, on) << "legs crossed";
  }
}

TEST(SelfCollision, TurnedOnStillStandsOnTheFloor) {
  Model model = modelWith(0.025);
  model.body.self_collision = true;
  RobotBody body{model};
  body.place(Pose{});
  run(body, holding(Pose{}), 2);
  EXPECT_GT(body.upright(), 0.99);
  EXPECT_NEAR(body.trunkPosition()[2], 0.3417, 0.003);
}

}  // namespace
}  // namespace darwinop::twin::test
