// Torque off: the start pose stays, standing straight falls. What holds the one, and joints that hold until driven.
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

Model shipped(const std::string& name) {
  return readModel(DARWINOP_MODELS "/" + name + ".ini");
}

constexpr std::size_t kFirstOfLegs = index(Joint::kPelvYR), kLastOfLegs = index(Joint::kFootL);

/// How far the legs are from the start pose, rad: the joint that is farthest.
double legsFromStart(const RobotBody& body) {
  double farthest = 0;
  for (std::size_t i = kFirstOfLegs; i <= kLastOfLegs; ++i)
    farthest =
        std::max(farthest, std::abs(body.state().joint[i].position_rad - radFromTicks(kJointTable[i].start).value));
  return farthest;
}

void expectRest(const RobotBody& body) {
  // What the runtime looks at before a controller may start: legs within 20 degrees of the start pose, and the
  // accelerometer within 32 counts of upright, 13.05 counts a m/s2. The body does far better with its legs.
  EXPECT_LT(legsFromStart(body), 0.05);  // measured 0.032
  const double counts = 32 / 13.05;
  EXPECT_NEAR(body.state().accel_m_s2[0], 0, counts);
  EXPECT_NEAR(body.state().accel_m_s2[1], 0, counts);
  EXPECT_NEAR(body.state().accel_m_s2[2], kGravity, counts);
  for (const double turning : body.state().gyro_rad_s) EXPECT_NEAR(turning, 0, 0.001);
}

TEST(StartPose, StaysWithTorqueOff) {
  RobotBody body{shipped("darwin-op")};
  run(body, limp(), 2);  // the arms sink
  const double after = legsFromStart(body);
  run(body, limp(), 18);
  expectRest(body);
  EXPECT_NEAR(legsFromStart(body), after, 0.001);  // and creeps nowhere
}

TEST(StandingStraight, HoldsWithTorqueAndFallsWithout) {
  for (const char* name : {"darwin-op", "webots-2013"}) {
    RobotBody body{shipped(name)};
    body.place(Pose{});
    run(body, holding(Pose{}), 5);
    EXPECT_GT(body.upright(), 0.99) << name;
    EXPECT_NEAR(body.trunkPosition()[2], 0.3417, 0.003) << name;  // hip 122.2 mm, leg 219.5 mm
    run(body, limp(), 3);
    EXPECT_LT(body.trunkPosition()[2], 0.25) << name;
    for (int kind = 0; kind < mjNWARNING; ++kind) EXPECT_EQ(body.mujocoData()->warning[kind].number, 0) << kind;
  }
}

// --- docs/twin/body.md, "Why the start pose stays"

struct HoldRow {
  TrunkCom com;
  double hip_nm, knee_nm, ankle_nm;  // each, what the weight above asks of it; positive where it falls forward
  double falls_nm, stays_nm;         // dry friction of all joints
};
constexpr HoldRow kHolds[] = {
    {TrunkCom::kManufacturer, -0.006, -0.829, 0.188, 0.175, 0.225},
    {TrunkCom::kHalfway, -0.093, -0.916, 0.101, 0.100, 0.125},
    {TrunkCom::kWebots2013, -0.197, -1.036, -0.030, 0.200, 0.225},
};

/// What the weight above both joints of a pair asks of each, N m.
double weightOn(RobotBody& body, Joint right, Joint left) {
  const mjModel& m = *body.mujocoModel();
  const mjData& d = *body.mujocoData();
  const auto joint = [&](Joint j) { return idOf(body, mjOBJ_JOINT, std::string{row(j).name}); };
  const int r = joint(right), l = joint(left);
  const double axis = (d.xanchor[3 * r] + d.xanchor[3 * l]) / 2;
  double moment = 0;
  for (int link = idOf(body, mjOBJ_BODY, "Body"); link < m.nbody; ++link) {
    bool above = true;
    for (int b = link; b > 0; b = m.body_parentid[b]) above = above && b != m.jnt_bodyid[r] && b != m.jnt_bodyid[l];
    if (above) moment += m.body_mass[link] * kGravity * (d.xipos[3 * link] - axis);
  }
  return moment / 2;
}

TEST(StartPose, AsksOfHipsKneesAndAnklesWhatTheTableSays) {
  for (const HoldRow& hold : kHolds) {
    Model model = modelWith();
    model.body.trunk_com = hold.com;
    RobotBody body{model, {.ball = Ball::kNone}};
    mj_forward(body.mujocoModel(), body.mujocoData());
    const double digit = 0.002;  // of the table
    EXPECT_NEAR(weightOn(body, Joint::kLegUpperR, Joint::kLegUpperL), hold.hip_nm, digit);
    EXPECT_NEAR(weightOn(body, Joint::kLegLowerR, Joint::kLegLowerL), hold.knee_nm, digit);
    EXPECT_NEAR(weightOn(body, Joint::kAnkleR, Joint::kAnkleL), hold.ankle_nm, digit);
  }
}

TEST(StartPose, StaysFromTheFrictionOnThatTheTableSays) {
  for (const HoldRow& hold : kHolds)
    for (const bool stays : {false, true}) {
      Model model = modelWith(stays ? hold.stays_nm : hold.falls_nm, 0.002);
      model.body.trunk_com = hold.com;
      RobotBody body{model, {.ball = Ball::kNone}};
      run(body, limp(), 10);
      EXPECT_EQ(legsFromStart(body) < 0.06, stays) << static_cast<int>(hold.com) << ", " << legsFromStart(body);
    }
}

// --- hold_until_driven

TEST(HoldUntilDriven, KeepsWhateverPoseNobodyDrove) {
  RobotBody body{shipped("webots-2013")};
  run(body, limp(), 20);
  expectRest(body);
  // Half a tick is the best that an encoder can say; measured 4e-6 rad.
  for (std::size_t i = kFirstOfLegs; i <= kLastOfLegs; ++i)
    EXPECT_NEAR(angleOf(body, static_cast<Joint>(i)), radFromTicks(kJointTable[i].start).value, 1e-4) << i;
  body.place(Pose{});
  run(body, limp(), 20);
  EXPECT_GT(body.upright(), 0.99);
}

TEST(HoldUntilDriven, EndsForEachJointWhenItIsDrivenFirst) {
  RobotBody body{shipped("webots-2013"), {.ball = Ball::kNone}};
  Pose out{};
  out[index(Joint::kArmUpperR)] = 0.8;
  out[index(Joint::kArmUpperL)] = -0.8;
  hangUp(body, out);
  run(body, limp(), 1);
  EXPECT_NEAR(angleOf(body, Joint::kArmUpperR), 0.8, 1e-4);
  Drives right = limp();
  right[index(Joint::kArmUpperR)] = holding(out)[index(Joint::kArmUpperR)];
  run(body, right, 0.016);  // one period of a controller
  EXPECT_NEAR(angleOf(body, Joint::kArmUpperR), 0.8, 0.01);
  run(body, limp(), 2);
  EXPECT_LT(angleOf(body, Joint::kArmUpperR), 0.2);  // falls, and is stopped by nothing but friction
  EXPECT_NEAR(angleOf(body, Joint::kArmUpperL), -0.8, 1e-4);
  hangUp(body, out);  // put back, it holds again
  run(body, limp(), 0.2);
  EXPECT_NEAR(angleOf(body, Joint::kArmUpperR), 0.8, 1e-4);
}

TEST(HoldUntilDriven, IsAskedForByTheModel) {
  Model model = shipped("webots-2013");
  model.body.hold_until_driven = false;
  RobotBody body{model};
  run(body, limp(), 3);
  EXPECT_GT(legsFromStart(body), 0.3);  // 0.025 N m do not hold it
}

}  // namespace
}  // namespace darwinop::twin::test
