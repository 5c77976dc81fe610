// What was found in a whole robot, in its model file.
#include "gap/report/body/body_additions.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "gap/plant/body/model_with.hpp"
#include "gap/report/body/body_report.hpp"
#include "gap/report/messages.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr const char* kModel = R"([model]
name = robot

[imu]
accel_bias = 0.1, 0, 0 m/s2

[effect coulomb]
friction = 0.02 N m

[effect coulomb AnkleR]
friction = 0.2 N m
)";

BodyAdditions added(const std::string& effects, const std::string& verdict = "named") {
  return bodyAdditionsIn(R"({"case": "c", "verdict": ")" + verdict + R"(", "effects": [)" + effects + "]}",
                         "report.json", "c", twin::parseModel(kModel, "m"));
}
twin::Model modelWith(const std::string& effects) {
  return twin::parseModel(withAdditions(kModel, added(effects).additions), "m");
}
double frictionOf(const twin::Model& model, std::optional<Joint> joint) {
  for (const twin::EffectSetting& effect : model.effects)
    if (effect.info->id == "coulomb" && effect.joint == joint) return effect.values.front();
  return -1;
}

TEST(BodyAdditions, AnEffectOfAPairGoesToBothJointsAndToNoOther) {
  const twin::Model model = modelWith(R"({"id": "coulomb", "at": ["AnkleR", "AnkleL"], "params": {"friction": 0.3}})");
  EXPECT_EQ(frictionOf(model, Joint::kAnkleR), 0.3);
  EXPECT_EQ(frictionOf(model, Joint::kAnkleL), 0.3);
  EXPECT_EQ(frictionOf(model, std::nullopt), 0.02);
}

TEST(BodyAdditions, AnEffectOfAllJointsReachesThoseWithASectionOfTheirOwn) {
  const twin::Model model = modelWith(R"({"id": "coulomb", "at": "all", "params": {"friction": 0.05}})");
  EXPECT_EQ(frictionOf(model, std::nullopt), 0.05);
  EXPECT_EQ(frictionOf(model, Joint::kAnkleR), 0.05);
}

TEST(BodyAdditions, AnAddedFrictionIsOnTopOfEachJointsOwn) {
  const twin::Model model =
      modelWith(R"({"id": "coulomb", "at": "all", "params": {"friction": 0.05, "friction_added": 0.05}})");
  EXPECT_NEAR(frictionOf(model, Joint::kAnkleR), 0.25, 1e-9);
  EXPECT_NEAR(frictionOf(model, Joint::kAnkleL), 0.07, 1e-9);
  EXPECT_NEAR(frictionOf(model, Joint::kNeck), 0.07, 1e-9);
}

TEST(BodyAdditions, TwoAdditionsToOneJointAreBothInItsNumber) {
  const std::string pair = R"({"id": "coulomb", "at": ["ArmUpperR", "ArmUpperL"],
                              "params": {"friction": 0.12, "friction_added": 0.1}})";
  const std::string more = R"({"id": "coulomb", "at": "ArmUpperR",
                              "params": {"friction": 0.17, "friction_added": 0.05}})";
  const std::string all = R"({"id": "coulomb", "at": "all", "params": {"friction_added": 0.01}})";
  const twin::Model model = modelWith(pair + "," + more + "," + all);
  EXPECT_NEAR(frictionOf(model, Joint::kArmUpperR), 0.18, 1e-9);
  EXPECT_NEAR(frictionOf(model, Joint::kArmUpperL), 0.13, 1e-9);
  EXPECT_NEAR(frictionOf(model, Joint::kNeck), 0.03, 1e-9);
}

TEST(BodyAdditions, ASensorsDeviationIsOnTopOfTheModels) {
  const twin::Model model = modelWith(
      R"({"id": "accel_bias", "at": "accelerometer", "params": {"bias": [0.2, 0, -0.1]}},
         {"id": "gyro_bias", "at": "gyro", "params": {"bias": [0, 0.05, 0]}},
         {"id": "imu_mounting", "at": "imu", "params": {"rotation": [0, 0, 0.1]}})");
  EXPECT_NEAR(model.imu.accel_bias_m_s2[0], 0.3, 1e-9);
  EXPECT_NEAR(model.imu.accel_bias_m_s2[2], -0.1, 1e-9);
  EXPECT_NEAR(model.imu.gyro_bias_rad_s[1], 0.05, 1e-9);
  EXPECT_NEAR(model.imu.mounting_rad[2], 0.1, 1e-9);
}

TEST(BodyAdditions, AFloorsNumbersReplaceTheModels) {
  const twin::Model model = modelWith(
      R"({"id": "floor_friction", "at": "floor", "params": {"friction": 0.25}},
         {"id": "contact_time", "at": "floor", "params": {"time": 0.03}})");
  EXPECT_EQ(model.body.floor_friction, 0.25);
  EXPECT_EQ(model.body.contact_time_s, 0.03);
}

TEST(BodyAdditions, AMassGoesToItsLinkWithItsPlace) {
  const std::string text =
      withAdditions(kModel, added(R"({"id": "link_mass", "at": "ArmLowerR", "params": {"mass": 0.055}},
                       {"id": "link_com", "at": "Body", "params": {"shift": [0, 0, -0.018]}})")
                                .additions);
  EXPECT_THAT(text, HasSubstr("[link ArmLowerR]\nmass = 0.055 kg  ; was 0 kg\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("mass_from_com")));
  const twin::Model model = twin::parseModel(text, "m");
  EXPECT_EQ(model.links[static_cast<std::size_t>(Joint::kArmLowerR)].mass_kg, 0.055);
  EXPECT_EQ(model.links[twin::kTrunkLink].com_shift_m[2], -0.018);
}

TEST(BodyAdditions, ASecondMassOfALinkKeepsWeightAndMoment) {
  const std::string light = R"({"id": "link_mass", "at": "Body", "params": {"mass": 0.2}})";
  const std::string one = withAdditions(kModel, added(light).additions);
  const BodyAdditions again = bodyAdditionsIn(R"({"case": "c", "verdict": "named", "effects": [)" + light + "]}",
                                              "report.json", "c", twin::parseModel(one, "m"));
  const twin::Model model = twin::parseModel(withAdditions(one, again.additions), "m");
  EXPECT_NEAR(model.links[twin::kTrunkLink].mass_kg, 0.4, 1e-9);
  EXPECT_NEAR(model.links[twin::kTrunkLink].mass_from_com_m[0], 0, 1e-6);
}

TEST(BodyAdditions, MassesThatCancelKeepTheirMoment) {
  const auto heavy = [](double mass_kg, double at_m) {
    FloorHypothesis robot;
    robot.robot.links.push_back({.link = Joint::kArmLowerR, .mass_kg = mass_kg, .from_com_m = {at_m, 0, 0}});
    return robot;
  };
  const twin::Model plain = twin::parseModel(kModel, "m");
  const auto com = [](const twin::Model& model) {
    const twin::MjModelPtr compiled = twin::loadBody(model, false);
    const int link = twin::mapBody(*compiled, model.body.xml).link[static_cast<std::size_t>(Joint::kArmLowerR)];
    return std::pair{compiled->body_mass[link], compiled->body_ipos[3 * link]};
  };
  const auto [was_kg, was_m] = com(plain);
  for (const double second_kg : {-0.05, -0.0499, 0.02}) {
    const twin::Model one = gap::modelWith(plain, heavy(0.05, 0.03), {}).model;
    const auto [with_kg, with_m] = com(one);
    const auto [kg, m] = com(gap::modelWith(one, heavy(second_kg, -0.01), {}).model);
    EXPECT_NEAR(kg, was_kg + 0.05 + second_kg, 1e-9);
    EXPECT_NEAR(kg * m, with_kg * with_m + second_kg * (with_m - 0.01), 1e-9) << was_m;
  }
}

TEST(BodyAdditions, FloorTiltSolesAndLateSensorsAreKeys) {
  const twin::Model model = modelWith(
      R"({"id": "floor_tilt", "at": "floor", "params": {"tilt": [0.04, -0.01]}},
         {"id": "sole_size", "at": "floor", "params": {"scale": 0.8}},
         {"id": "gyro_axes", "at": "gyro", "params": {"map": [2, -1, 3]}},
         {"id": "gyro_lowpass", "at": "gyro", "params": {"time": 0.03}},
         {"id": "imu_delay", "at": "imu", "params": {"delay": 0.012}},
         {"id": "battery_resistance", "at": "battery", "params": {"resistance": 0.2}})");
  EXPECT_EQ(model.body.floor_tilt_x_rad, 0.04);
  EXPECT_EQ(model.body.floor_tilt_y_rad, -0.01);
  EXPECT_EQ(model.body.sole_size, 0.8);
  EXPECT_EQ(model.imu.gyro_axes, (std::array<double, 3>{2, -1, 3}));
  EXPECT_EQ(model.imu.gyro_lowpass_s, 0.03);
  EXPECT_EQ(model.imu.delay_s, 0.012);
  EXPECT_EQ(model.body.battery_resistance_ohm, 0.2);
}

TEST(BodyAdditions, TwoFiltersOfOneSensorAreAConflict) {
  const std::string filter = R"({"id": "gyro_lowpass", "at": "gyro", "params": {"time": 0.03}})";
  const std::string one = withAdditions(kModel, added(filter).additions);
  const BodyAdditions again = bodyAdditionsIn(R"({"case": "c", "verdict": "named", "effects": [)" + filter + "]}",
                                              "report.json", "c", twin::parseModel(one, "m"));
  ASSERT_THAT(again.left_out, SizeIs(1));
  EXPECT_THAT(again.left_out.front(), HasSubstr("gyro_lowpass"));
  EXPECT_EQ(withAdditions(one, again.additions), one);
}

TEST(BodyAdditions, ExchangedAxesOfAGyroscopeLeaveTheScaleOfTheAxesThatAreRead) {
  const std::string scale = R"({"id": "gyro_scale", "at": "gyro", "params": {"scale": [1.1, 1, 1]}})";
  const std::string map = R"({"id": "gyro_axes", "at": "gyro", "params": {"map": [2, 1, 3]}})";
  const std::string one = withAdditions(kModel, added(scale).additions);
  const BodyAdditions again = bodyAdditionsIn(R"({"case": "c", "verdict": "named", "effects": [)" + map + "]}",
                                              "report.json", "c", twin::parseModel(one, "m"));
  EXPECT_THAT(again.left_out, SizeIs(0));
  const twin::ImuSettings imu = twin::parseModel(withAdditions(one, again.additions), "m").imu;
  EXPECT_EQ(imu.gyro_axes, (std::array<double, 3>{2, 1, 3}));
  EXPECT_EQ(imu.gyro_scale, (std::array<double, 3>{1.1, 1, 1}));
}

TEST(BodyAdditions, AnEffectThatDoesNotExistIsRefusedByItsName) {
  try {
    (void)added(R"({"id": "gyro_bais", "at": "gyro", "params": {"bias": [0, 0, 0]}})");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no effect gyro_bais at \"gyro\"; did you mean gyro_bias"));
  }
}

TEST(BodyAdditions, OntoAnotherModelThanThatOfTheSearchAreReported) {
  BodyCase robot;
  robot.name = "c", robot.joints.model = twin::parseModel(kModel, "m");
  const std::string answer = reportOf(robot, {}, kModel).answer.dump();
  const auto warning = [](const std::string& results, const std::string& model) {
    return otherModelWarning(results, "report.json", "c", model);
  };
  EXPECT_EQ(warning(answer, kModel), "");
  EXPECT_EQ(warning(answer, std::string{kModel} + "\n[effect viscous]\ndamping = 0.01 N m s/rad\n"),
            std::string{"report.json"} + messages::kOtherModel);
  EXPECT_EQ(warning(R"({"case": "c"})", kModel), "") << "of an older version";
}

TEST(BodyAdditions, AResultThatNamesNothingOrIsOfAnotherCaseIsRefused) {
  EXPECT_THROW((void)added("", "unknown"), std::runtime_error);
  EXPECT_THROW((void)bodyAdditionsIn(R"({"case": "other", "verdict": "named", "effects": []})", "report.json", "c",
                                     twin::parseModel(kModel, "m")),
               std::runtime_error);
}

}  // namespace
}  // namespace darwinop::gap
