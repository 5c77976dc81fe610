// Anchors, axes, signs and lengths of the body, against the table of the 2013 model and by looking where limbs go.
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

struct AnchorRow {
  Joint joint;
  Vec anchor;  // m, in the trunk, all joints at zero: left, up, forward
};
constexpr std::array<AnchorRow, kJoints> kAnchors{{
    {Joint::kShoulderR, {-0.082, 0, 0}},
    {Joint::kShoulderL, {0.082, 0, 0}},
    {Joint::kArmUpperR, {-0.082, -0.016, 0}},
    {Joint::kArmUpperL, {0.082, -0.016, 0}},
    {Joint::kArmLowerR, {-0.124426, -0.058426, 0.016}},
    {Joint::kArmLowerL, {0.124426, -0.058426, 0.016}},
    {Joint::kPelvYR, {-0.037, -0.1222, -0.005}},
    {Joint::kPelvYL, {0.037, -0.1222, -0.005}},
    {Joint::kPelvR, {-0.037, -0.1222, -0.005}},
    {Joint::kPelvL, {0.037, -0.1222, -0.005}},
    {Joint::kLegUpperR, {-0.037, -0.1222, -0.005}},
    {Joint::kLegUpperL, {0.037, -0.1222, -0.005}},
    {Joint::kLegLowerR, {-0.037, -0.2152, -0.005}},
    {Joint::kLegLowerL, {0.037, -0.2152, -0.005}},
    {Joint::kAnkleR, {-0.037, -0.3082, -0.005}},
    {Joint::kAnkleL, {0.037, -0.3082, -0.005}},
    {Joint::kFootR, {-0.037, -0.3082, -0.005}},
    {Joint::kFootL, {0.037, -0.3082, -0.005}},
    {Joint::kNeck, {0, 0.051, 0}},
    {Joint::kHead, {0, 0.051, 0}},
}};

class Kinematics : public testing::Test {
 protected:
  // Where a point of the link that this joint carries stands in the trunk.
  Vec pointOf(Joint joint, const Vec& in_link) {
    const int link = idOf(body_, mjOBJ_BODY, std::string{row(joint).name});
    const mjData& d = *body_.mujocoData();
    mjtNum world[3];
    mju_rotVecMat(world, in_link.data(), d.xmat + 9 * link);
    mju_addTo3(world, d.xpos + 3 * link);
    return inTrunk(body_, world);
  }
  // How a point of the whole limb behind a joint moves when only that joint turns, per rad.
  Vec moves(Joint joint, Joint last, const Vec& in_link, Pose from = {}) {
    constexpr double kTurn = 1e-4;
    pose(body_, from);
    const Vec before = pointOf(last, in_link);
    from[index(joint)] += kTurn;
    pose(body_, from);
    Vec way = pointOf(last, in_link);
    for (std::size_t k = 0; k < 3; ++k) way[k] = (way[k] - before[k]) / kTurn;
    return way;
  }
  RobotBody body_{modelWith()};
};

TEST_F(Kinematics, EveryJointIsAnchoredWhereTheTableSays) {
  pose(body_, {});
  for (const auto& [joint, anchor] : kAnchors) {
    const int id = idOf(body_, mjOBJ_JOINT, std::string{row(joint).name});
    const Vec found = inTrunk(body_, body_.mujocoData()->xanchor + 3 * id);
    // The table has whole micrometres.
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], anchor[k], 1e-6) << row(joint).name << " axis " << k;
  }
}

// The words of the table: which way a limb goes when a servo counts up. Component: 0 left, 1 up, 2 forward.
struct EffectRow {
  Joint joint, last;  // what turns; whose link is looked at
  Vec point;          // in that link: hand, toe, camera
  std::size_t component;
  int sign;
};
constexpr Vec kHand{0, -0.12, 0}, kAnkle{0, -0.0335, 0}, kToe{0, -0.0335, 0.05}, kLeftEdge{0.03, -0.0335, 0},
    kCamera{0, 0.0329, 0.036};
const std::array<EffectRow, kJoints> kEffects{{
    {Joint::kShoulderR, Joint::kArmUpperR, kHand, 2, 1},   // arm swings forward
    {Joint::kShoulderL, Joint::kArmUpperL, kHand, 2, -1},  // backward
    {Joint::kArmUpperR, Joint::kArmUpperR, kHand, 0, -1},  // to the right
    {Joint::kArmUpperL, Joint::kArmUpperL, kHand, 0, -1},  // to the right
    {Joint::kArmLowerR, Joint::kArmLowerR, kHand, 1, 1},   // flexes: the forearm points forward, the hand rises
    {Joint::kArmLowerL, Joint::kArmLowerL, kHand, 1, -1},  // extends
    {Joint::kPelvYR, Joint::kFootR, kToe, 0, -1},          // toe to the right
    {Joint::kPelvYL, Joint::kFootL, kToe, 0, -1},          // toe to the right
    {Joint::kPelvR, Joint::kFootR, kAnkle, 0, -1},         // leg to the right
    {Joint::kPelvL, Joint::kFootL, kAnkle, 0, -1},         // leg to the right
    {Joint::kLegUpperR, Joint::kFootR, kAnkle, 2, -1},     // thigh backward
    {Joint::kLegUpperL, Joint::kFootL, kAnkle, 2, 1},      // thigh forward
    {Joint::kLegLowerR, Joint::kFootR, kAnkle, 2, -1},     // knee flexes, shank back
    {Joint::kLegLowerL, Joint::kFootL, kAnkle, 2, 1},      // knee extends, shank forward
    {Joint::kAnkleR, Joint::kFootR, kToe, 1, 1},           // toe up
    {Joint::kAnkleL, Joint::kFootL, kToe, 1, -1},          // toe down
    {Joint::kFootR, Joint::kFootR, kLeftEdge, 1, 1},       // left edge up
    {Joint::kFootL, Joint::kFootL, kLeftEdge, 1, 1},       // left edge up
    {Joint::kNeck, Joint::kHead, kCamera, 0, 1},           // looks left
    {Joint::kHead, Joint::kHead, {0, 0, 0.036}, 1, 1},     // looks up
}};

TEST_F(Kinematics, ARisingTickMovesEveryLimbTheWayTheTableSays) {
  for (const EffectRow& effect : kEffects) {
    const Vec way = moves(effect.joint, effect.last, effect.point);
    // A lever of 2 cm at least, so that no sign hangs on rounding.
    EXPECT_GT(way[effect.component] * effect.sign, 0.02) << row(effect.joint).name;
  }
}

TEST_F(Kinematics, AStraightLegIs2195MillimetresLong) {
  body_.place(Pose{});
  const int hip = idOf(body_, mjOBJ_BODY, "LegUpperR"), sole = idOf(body_, mjOBJ_GEOM, "FootR_1");
  const mjData& d = *body_.mujocoData();
  const double bottom = d.geom_xpos[3 * sole + 2] - body_.mujocoModel()->geom_size[3 * sole + 1];
  EXPECT_NEAR(d.xpos[3 * hip + 2] - bottom, 0.2195, 1e-9);
}

TEST_F(Kinematics, StandsOnBothSolesWithTheTrunkAt3417Millimetres) {
  body_.place(Pose{});
  EXPECT_NEAR(body_.trunkPosition()[2], 0.3417, 1e-9);
  EXPECT_NEAR(body_.upright(), 1, 1e-12);
}

TEST_F(Kinematics, EveryGoalAServoTakesIsWithinTheJointsRange) {
  for (const JointRow& joint : kJointTable) {
    const int id = idOf(body_, mjOBJ_JOINT, std::string{joint.name});
    const mjtNum* range = body_.mujocoModel()->jnt_range + 2 * id;
    EXPECT_LE(range[0], radFromTicks(joint.low).value + 1e-8) << joint.name;
    EXPECT_GE(range[1], radFromTicks(joint.high).value - 1e-8) << joint.name;
    // Not more than what the two sources differ by: 0.29 rad, of the right shoulder.
    EXPECT_GT(range[0], radFromTicks(joint.low).value - 0.3) << joint.name;
    EXPECT_LT(range[1], radFromTicks(joint.high).value + 0.13) << joint.name;
  }
}

TEST_F(Kinematics, TheCameraLooks45DegreesDownAtZeroAndLevelAt0785) {
  const int camera = idOf(body_, mjOBJ_CAMERA, "head");
  const auto height_of_view = [&](double head) {
    Pose angles{};
    angles[index(Joint::kHead)] = head;
    body_.place(Pose{});
    pose(body_, angles);
    return -body_.mujocoData()->cam_xmat[9 * camera + 8];  // looks along its own -z
  };
  EXPECT_NEAR(height_of_view(0), -std::sin(0.7854), 1e-9);
  EXPECT_NEAR(height_of_view(0.7854), 0, 1e-9);
  // 58 degrees wide at 4:3.
  const double wide = 2 * std::atan(std::tan(body_.mujocoModel()->cam_fovy[camera] * kRadPerDegree / 2) * 4 / 3);
  EXPECT_NEAR(wide, 1.0123, 1e-6);
}

}  // namespace
}  // namespace darwinop::twin::test
