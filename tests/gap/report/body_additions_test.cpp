// What was found in a whole robot, in its model file.
#include "gap/report/body/body_additions.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace darwinop::gap {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
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

TEST(BodyAdditions, ATiltAndAMassAreReportedAsLeftOut) {
  EXPECT_THAT(added(R"({"id": "floor_tilt", "at": "floor", "params": {"tilt": [0.1, 0]}})").left_out, SizeIs(1));
  const BodyAdditions found = added(R"({"id": "link_mass", "at": "ArmLowerR", "params": {"mass": 0.05}})");
  EXPECT_THAT(found.additions.effects, IsEmpty());
  ASSERT_THAT(found.left_out, SizeIs(1));
  EXPECT_THAT(found.left_out.front(), HasSubstr("ArmLowerR"));
}

TEST(BodyAdditions, AResultThatNamesNothingOrIsOfAnotherCaseIsRefused) {
  EXPECT_THROW((void)added("", "unknown"), std::runtime_error);
  EXPECT_THROW((void)bodyAdditionsIn(R"({"case": "other", "verdict": "named", "effects": []})", "report.json", "c",
                                     twin::parseModel(kModel, "m")),
               std::runtime_error);
}

}  // namespace
}  // namespace darwinop::gap
