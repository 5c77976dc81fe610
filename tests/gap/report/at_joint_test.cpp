// What was found at one joint, in the model of the robot.
#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <stdexcept>

#include "gap/report/addition.hpp"
#include "gap/report/report_rig.hpp"
#include "gap/small_case.hpp"
#include "hal/text_file.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::gap {
namespace {

const std::string kRobot = "darwin-op";

Case caseOf(Joint joint) {
  Case given = twoLogs();
  given.joint = joint;
  return given;
}

/// The shipped robot with these effects, added by hand for a case of the joint.
twin::Model robotWith(const std::vector<std::string>& effects, const Case& given) {
  const std::string path = twin::findModel(kRobot);
  twin::Model model =
      twin::parseModel(withAdditions(readTextFile(path).value(), atJoint(additionsFrom(effects), given)), "m");
  model.folder = twin::readModel(path).folder;
  return model;
}

/// Mass and shift of the link.
std::vector<double> massAt(const twin::Model& model, Joint joint) {
  for (const twin::EffectSetting& effect : servoEffects(model, joint))
    if (effect.info->id == "com_mass") return effect.values;
  return {};
}

/// Gravity's torque at the joint, all joints at 0, N m.
double torqueAt(const twin::Model& model, Joint joint) {
  twin::RobotBody body{model};
  const mjModel& m = *body.mujocoModel();
  mjData& d = *body.mujocoData();
  mju_copy(d.qpos, m.qpos0, m.nq);
  mju_zero(d.qvel, m.nv);
  mj_forward(&m, &d);
  return d.qfrc_bias[m.jnt_dofadr[mj_name2id(&m, mjOBJ_JOINT, std::string{row(joint).name}.c_str())]];
}

// On the bench it is the mass of the whole limb.
TEST(AtJoint, AMassIsThatOfAllLinksThatTheJointCarries) {
  const twin::Model heavier = robotWith({"com_mass.mass=0.3", "com_mass.shift=0"}, caseOf(Joint::kArmUpperR));
  for (const Joint joint : {Joint::kArmUpperR, Joint::kArmLowerR})
    EXPECT_THAT(massAt(heavier, joint), testing::ElementsAre(0.3, 0)) << row(joint).name;
  for (const Joint joint : {Joint::kShoulderR, Joint::kArmLowerL, Joint::kNeck})
    EXPECT_THAT(massAt(heavier, joint), testing::IsEmpty()) << row(joint).name;
}

TEST(AtJoint, AMassActsInTheTwinAsOnTheBench) {
  for (const Joint joint : {Joint::kShoulderR, Joint::kLegUpperL, Joint::kHead}) {
    const twin::Model as_is = twin::readModel(twin::findModel(kRobot));
    const twin::Model heavier = robotWith({"com_mass.mass=0.3", "com_mass.shift=0"}, caseOf(joint));
    const double torque = torqueAt(as_is, joint);
    ASSERT_GT(std::abs(torque), 1e-3) << row(joint).name;
    EXPECT_NEAR(torqueAt(heavier, joint) / torque, 1.3, 0.005) << row(joint).name;
  }
}

TEST(AtJoint, AShiftIsAMassOfEqualMoment) {
  const Case given = caseOf(Joint::kArmUpperR);
  const twin::Pendulum arm = armOf(given, given.logs.front());
  const double moment = (arm.payload_kg + arm.arm_mass_kg / 2) * arm.length_m, shift = 0.01;
  const double more = shift * (arm.payload_kg + arm.arm_mass_kg) / moment;
  const twin::Model shifted = robotWith({"com_mass.mass=0.1", "com_mass.shift=0.01"}, given);
  EXPECT_NEAR(massAt(shifted, Joint::kArmLowerR)[0], 1.1 * (1 + more) - 1, 1e-4);
  EXPECT_EQ(massAt(shifted, Joint::kArmLowerR)[1], 0);
  const twin::Model most = robotWith({"com_mass.mass=0.4", "com_mass.shift=0.05"}, given);
  EXPECT_EQ(massAt(most, Joint::kArmUpperR)[0], 0.4) << "the most that a model may have";
  try {
    robotWith({"com_mass.shift=0.01"}, given);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(messages::kShiftNeedsMass));
  }
}

}  // namespace
}  // namespace darwinop::gap
