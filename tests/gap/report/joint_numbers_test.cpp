// Numbers of one joint's servo in the model of a robot.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "gap/report/read_results.hpp"
#include "gap/report/report_rig.hpp"
#include "twin/servo/servo.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr Joint kShoulder = Joint::kShoulderR;
constexpr const char* kOneRobot =
    "[model]\nname = robot\n[servo]\nkt = 1.786 N m/A\nback_emf = 1.9 V s/rad\nresistance = 8 ohm\n"
    "[effect resistance_error]\nchange = 0.05\n";

twin::Model robot() {
  return twin::parseModel(kOneRobot, "m");
}

/// As `gap run` of a case of the shoulder moves them, by these factors.
Additions movedBy(double kt, double back_emf, double resistance) {
  const twin::ServoParameters was = robot().servo;
  Case given;
  given.joint = kShoulder;
  return atJoint({.numbers = {{"kt", kt * was.kt_nm_a},
                              {"back_emf", back_emf * was.back_emf_vs_rad},
                              {"resistance", resistance * was.resistance_ohm},
                              {"armature", was.armature_kgm2 + 0.001}},
                  .effects = {}},
                 given);
}

/// Of a servo that is driven while it turns.
twin::Actuation actuationOf(const twin::Model& model, Joint joint) {
  twin::Servo servo{model.servo, effectsOf(model, joint)};
  servo.reset(0);
  servo.firmware({.torque_on = true, .goal_rad = 0.2, .speed_limit_rad_s = 100, .torque_limit = 1}, 0, 1);
  twin::Actuation out = servo.actuate(0, 1, 0);
  out.friction_nm = servo.parameters().armature_kgm2 + servo.load().armature_kgm2;
  return out;
}

void expectSame(const twin::Actuation& is, const twin::Actuation& wanted) {
  EXPECT_NEAR(is.torque_nm, wanted.torque_nm, 1e-5 * std::abs(wanted.torque_nm));
  EXPECT_NEAR(is.damping_nms_rad, wanted.damping_nms_rad, 1e-5 * wanted.damping_nms_rad);
  EXPECT_NEAR(is.friction_nm, wanted.friction_nm, 1e-8) << "inertia of the rotor";
}

TEST(JointNumbers, ChangeTheServoOfThatJointAndNoOther) {
  const Additions additions = movedBy(1.03, 1.03, 0.94);
  const twin::Model now = twin::parseModel(withAdditions(kOneRobot, additions), "m");
  twin::Model wanted = robot();
  wanted.servo.kt_nm_a *= 1.03, wanted.servo.back_emf_vs_rad *= 1.03, wanted.servo.resistance_ohm *= 0.94;
  wanted.servo.armature_kgm2 += 0.001;
  expectSame(actuationOf(now, kShoulder), actuationOf(wanted, kShoulder));
  expectSame(actuationOf(now, Joint::kNeck), actuationOf(robot(), Joint::kNeck));
  EXPECT_THAT(
      changesBy(additions, robot()),
      ElementsAre("kt_error at ShoulderR added", "resistance_error at ShoulderR added", "inertia at ShoulderR added"));
  EXPECT_THAT(withAdditions(kOneRobot, additions), HasSubstr(messages::kTogether + std::string{"7.896 ohm"}));
}

TEST(JointNumbers, BesideAnEffectThatWasFoundAreInIt) {
  Additions additions = movedBy(1.03, 1.03, 0.94);
  additions.effects.push_back({"resistance_error", {{"change", 0.1, 0.08, 0.12}}, {}, {kShoulder}});
  const twin::Model now = twin::parseModel(withAdditions(kOneRobot, additions), "m");
  const std::vector<twin::EffectSetting> effects = servoEffects(now, kShoulder);
  const auto there = std::ranges::find(effects, "resistance_error", [](const auto& one) { return one.info->id; });
  ASSERT_NE(there, effects.end());
  EXPECT_NEAR(there->values[0], 0.94 * 1.1 - 1, 1e-6);
}

/// Of a case of the shoulder: `resistance_error`, and numbers of the servo that the fit has moved.
Outcome resistanceError(const Case& given) {
  Outcome outcome;
  outcome.baseline = baselineOf(given);
  Identification& found = outcome.identification;
  found.verdict = Verdict::kNamed;
  found.model = outcome.baseline;
  found.model.with(*twin::findEffect("resistance_error")).values = {0.1};
  found.model.servo.resistance_ohm *= 0.94;
  found.model.servo.kt_nm_a *= 1.03, found.model.servo.back_emf_vs_rad *= 1.03;
  found.effects = {{twin::findEffect("resistance_error"), {{"resistance_error.change", "", 0.1, 0.08, 0.12}}, 50}};
  return outcome;
}

double resistanceErrorAt(const twin::Model& model, Joint joint) {
  for (const twin::EffectSetting& effect : servoEffects(model, joint))
    if (effect.info->id == "resistance_error") return effect.values.front();
  return std::nan("");
}

TEST(JointNumbers, OfTheJsonAreThoseOfTheModelFile) {
  Case given = twoLogs();
  given.model = robot();
  given.joint = kShoulder;
  const Outcome outcome = resistanceError(given);
  const nlohmann::json answer = asJson(given, outcome), effect = answer["effects"][0];
  const std::string model = caseModel(given);
  const twin::Model repaired = twin::parseModel(withAdditions(model, additionsOf(given, outcome, "")), "m");
  EXPECT_NEAR(effect["in_model"]["change"].get<double>(), 0.94 * 1.1 - 1, 1e-3);
  EXPECT_EQ(effect["in_model"]["change"], resistanceErrorAt(repaired, kShoulder));
  EXPECT_EQ(effect["params"]["change"], 0.1);
  EXPECT_TRUE(effect["interval_90"]["change"][0].is_null()) << "it was that of the effect alone";
  EXPECT_TRUE(answer["numbers"].empty()) << answer["numbers"];
  ASSERT_EQ(answer["moved"].size(), 1U);
  EXPECT_EQ(answer["moved"][0]["id"], "kt_error");
  const Additions again = additionsIn(answer.dump(), "results.json", given);
  EXPECT_EQ(twin::writeModel(twin::parseModel(withAdditions(model, again), "m")), twin::writeModel(repaired));
}

TEST(JointNumbers, ThatNoEffectHasStayThoseOfAllJoints) {
  EXPECT_THAT(changesBy(movedBy(1.03, 1, 1.4), robot()),
              ElementsAre("inertia at ShoulderR added", "[servo] kt changed, for all joints",
                          "[servo] back_emf changed, for all joints", "[servo] resistance changed, for all joints"));
}

}  // namespace
}  // namespace darwinop::gap
