// Masses, centres of mass and inertias, and the choices that a model has about doubtful ones.
#include "twin/body/support.hpp"
#include "twin/body/trunk.hpp"

namespace darwinop::twin::test {
namespace {

struct MassRow {
  const char* link;
  double grams;  // rounded, from the thesis of 2013, appendix B
};
constexpr std::array kMasses{
    MassRow{"Body", 976},      MassRow{"Neck", 24},       MassRow{"Head", 158},     MassRow{"ShoulderR", 26},
    MassRow{"ArmUpperR", 168}, MassRow{"ArmLowerR", 59},  MassRow{"ShoulderL", 26}, MassRow{"ArmUpperL", 168},
    MassRow{"ArmLowerL", 59},  MassRow{"PelvYR", 27},     MassRow{"PelvR", 167},    MassRow{"LegUpperR", 119},
    MassRow{"LegLowerR", 70},  MassRow{"AnkleR", 167},    MassRow{"FootR", 79},     MassRow{"PelvYL", 27},
    MassRow{"PelvL", 167},     MassRow{"LegUpperL", 119}, MassRow{"LegLowerL", 70}, MassRow{"AnkleL", 167},
    MassRow{"FootL", 79},
};

RobotBody robot(TrunkCom com, TrunkInertia inertia = TrunkInertia::kBox) {
  Model model = modelWith();
  model.body.trunk_com = com;
  model.body.trunk_inertia = inertia;
  return RobotBody{model, {.ball = Ball::kNone}};
}

Vec centreOfMass(RobotBody& body) {
  pose(body, {});
  return inTrunk(body, body.mujocoData()->subtree_com + 3 * idOf(body, mjOBJ_BODY, "Body"));
}

TEST(Mass, OfEveryLinkIsTheThesis) {
  RobotBody body{modelWith()};
  for (const auto& [link, grams] : kMasses)
    EXPECT_NEAR(body.mujocoModel()->body_mass[idOf(body, mjOBJ_BODY, link)] * 1000, grams, 0.5) << link;
}

TEST(Mass, OfTheRobotIs2925Grams) {
  RobotBody body{modelWith(), {.ball = Ball::kNone}};
  EXPECT_NEAR(mj_getTotalmass(body.mujocoModel()), 2.9253241, 1e-7);
}

// Table of docs/twin/body.md, whole tenths of millimetres: left, up, forward.
TEST(CentreOfMass, OfTheRobotFollowsTheChoiceForTheTrunk) {
  struct Row {
    TrunkCom choice;
    Vec mm;
  };
  for (const auto& [choice, mm] :
       {Row{TrunkCom::kWebots2013, {0, -127.6, -19.1}}, Row{TrunkCom::kManufacturer, {-1.0, -114.0, -8.9}},
        Row{TrunkCom::kHalfway, {-0.5, -120.8, -14.0}}}) {
    RobotBody body = robot(choice);
    const Vec found = centreOfMass(body);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k] * 1000, mm[k], 0.1) << static_cast<int>(choice);
  }
}

TEST(TrunkInertia, IsThePublishedMatrixWhenAsked) {
  RobotBody body = robot(TrunkCom::kWebots2013, TrunkInertia::kPublished);
  const mjModel& m = *body.mujocoModel();
  const int trunk = idOf(body, mjOBJ_BODY, "Body");
  mjtNum axes[9];
  mju_quat2Mat(axes, m.body_iquat + 4 * trunk);
  const auto element = [&](int a, int b) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += axes[3 * a + k] * m.body_inertia[3 * trunk + k] * axes[3 * b + k];
    return sum * 1e6;
  };
  EXPECT_NEAR(element(0, 0), 3108.18, 1e-4);
  EXPECT_NEAR(element(1, 1), 6378.7776, 1e-4);
  EXPECT_NEAR(element(2, 2), 5331.6425, 1e-4);
  EXPECT_NEAR(element(0, 1), -254.60189, 1e-4);
  EXPECT_NEAR(element(0, 2), 2031.8174, 1e-4);
  EXPECT_NEAR(element(1, 2), 164.17863, 1e-4);
}

TEST(TrunkInertia, IsThatOfABoxOtherwise) {
  RobotBody body = robot(TrunkCom::kManufacturer);
  const mjtNum* moments = body.mujocoModel()->body_inertia + 3 * idOf(body, mjOBJ_BODY, "Body");
  EXPECT_NEAR(moments[0] * 1e3, 2.23, 0.005);
  EXPECT_NEAR(moments[1] * 1e3, 2.08, 0.005);
  EXPECT_NEAR(moments[2] * 1e3, 2.27, 0.005);
}

TEST(Load, EffectsMoveAndScaleTheWeightOfOneLink) {
  Model model = modelWith();
  const EffectInfo* mass = findEffect("com_mass");
  ASSERT_NE(mass, nullptr);
  std::vector<double> values;
  for (const Parameter& parameter : mass->parameters) values.push_back(parameter.neutral);
  values[0] = mass->parameters[0].high;
  model.effects.push_back({mass, values, Joint::kArmLowerR});
  RobotBody changed{model}, plain{modelWith()};
  const int link = idOf(plain, mjOBJ_BODY, "ArmLowerR");
  EXPECT_GT(changed.mujocoModel()->body_mass[link], plain.mujocoModel()->body_mass[link] * 1.01);
  const int other = idOf(plain, mjOBJ_BODY, "ArmLowerL");
  EXPECT_EQ(changed.mujocoModel()->body_mass[other], plain.mujocoModel()->body_mass[other]);
}

constexpr double kOffset = 0.12;

Model offsetAt(Joint joint, double dry_friction_nm = 0) {
  Model model = modelWith(dry_friction_nm);
  model.effects.push_back({findEffect("encoder_offset"), {kOffset}, joint});
  return model;
}

Pose bent() {
  Pose angles{};
  for (std::size_t i = 0; i < kJoints; ++i) angles[i] = 0.05 * static_cast<double>(i % 7) - 0.1;
  return angles;
}

// reading = true angle + offset, so a body with the offset stands as one without it does at a smaller angle.
TEST(EncoderOffset, TurnsTheLinkAndAllBeyondItInEveryJoint) {
  for (const JointRow& joint : kJointTable) {
    const Joint which = static_cast<Joint>(&joint - kJointTable.data());
    RobotBody off{offsetAt(which), {.ball = Ball::kNone}}, right{modelWith(), {.ball = Ball::kNone}};
    Pose truth = bent();
    truth[index(which)] -= kOffset;
    for (RobotBody* body : {&off, &right}) body->place(Pose{});
    mju_copy(trunkQpos(off), trunkQpos(right), 7);
    pose(off, bent());
    pose(right, truth);
    const mjModel& m = *off.mujocoModel();
    const mjData &a = *off.mujocoData(), &b = *right.mujocoData();
    for (int k = 0; k < 3 * m.nbody; ++k) EXPECT_NEAR(a.xpos[k], b.xpos[k], 1e-12) << joint.name;
    for (int k = 0; k < 3 * m.nbody; ++k) EXPECT_NEAR(a.xipos[k], b.xipos[k], 1e-12) << joint.name;
    for (int k = 0; k < 3 * m.ngeom; ++k) EXPECT_NEAR(a.geom_xpos[k], b.geom_xpos[k], 1e-12) << joint.name;
    for (int k = 0; k < 4 * m.nbody; ++k) EXPECT_NEAR(a.xquat[k], b.xquat[k], 1e-12) << joint.name;
    for (int k = 0; k < m.nv; ++k) EXPECT_NEAR(a.qfrc_bias[k], b.qfrc_bias[k], 1e-9) << joint.name;
  }
}

TEST(EncoderOffset, LeavesTheStopsWhereTheyAre) {
  RobotBody off{offsetAt(Joint::kArmUpperR)}, right{modelWith()};
  const int joint = idOf(right, mjOBJ_JOINT, "ArmUpperR");
  for (int end = 0; end < 2; ++end)
    EXPECT_NEAR(off.mujocoModel()->jnt_range[2 * joint + end],
                right.mujocoModel()->jnt_range[2 * joint + end] + kOffset, 1e-12);
}

}  // namespace
}  // namespace darwinop::twin::test
