// A case of the whole robot: what is read, what is refused, and with which facts.
#include <gmock/gmock.h>

#include "gap/body/edited_columns.hpp"
#include "gap/body/synthetic_robot.hpp"
#include "gap/case/body/body_check.hpp"
#include "gap/case/body/clamped_trunk.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(BodyCase, IsReadWithItsJointsAndItsSensor) {
  SyntheticRobot robot;
  robot.limp_joint = index(Joint::kNeck);
  robot.p_gain_late = 1;
  const BodyCase c = BodyTexts{robot}.read();
  EXPECT_EQ(c.name, "robot");
  EXPECT_EQ(c.joints.model.name, "darwin-op");
  ASSERT_EQ(c.logs.size(), 6u);
  EXPECT_EQ(c.joints.logs.size(), 6 * kJoints);
  EXPECT_EQ(c.logs[0].setup, BodySetup::kClamped);
  EXPECT_EQ(c.logs[4].setup, BodySetup::kFloor);
  EXPECT_EQ(c.logs[1].repeat_of, 0u);
  EXPECT_TRUE(c.logs[5].held_out);
  EXPECT_EQ(c.logs[2].up, (Axes{-1, 0, 0}));
  EXPECT_NEAR(c.logs[2].accel_m_s2[0][9], 9.81, 0.3);
  const Trajectory& neck = c.joint(2, index(Joint::kNeck));
  EXPECT_EQ(neck.joint, Joint::kNeck);
  EXPECT_EQ(neck.torque_on[59], 1);
  EXPECT_EQ(neck.torque_on[60], 0);
  EXPECT_EQ(neck.pRegisterAt(79), 32);  // gain 4
  EXPECT_EQ(neck.pRegisterAt(80), 8);
  EXPECT_EQ(neck.supply_v, 11.8);
  EXPECT_TRUE(std::isnan(neck.volt_v[1])) << "not known is not zero";
  EXPECT_TRUE(std::isnan(neck.temp_c[0])) << "a column that is missing is not known";
}

TEST(BodyCase, AnErrorNamesTheFileTheLineAndTheField) {
  const BodyTexts good;
  ASSERT_EQ(good.error(), "");
  EXPECT_THAT(good.withLog("side.csv", "AnkleR.position [rad]", "AnkleR.position [deg]").error(),
              AllOf(HasSubstr("my/side.csv"), HasSubstr("AnkleR.position"), HasSubstr("deg")));
  EXPECT_THAT(good.withLog("side.csv", "AnkleR.position [rad]", "AnkelR.position [rad]").error(),
              AllOf(HasSubstr("my/side.csv"), HasSubstr("AnkleR.position")));
  EXPECT_THAT(good.withLog("side.csv", "gyro.y [rad/s]", "gyro.y [deg/s]").error(),
              AllOf(HasSubstr("my/side.csv"), HasSubstr("gyro.y"), HasSubstr("deg/s")));
  EXPECT_THAT(good.withLog("side.csv", "\n0.032000,3,", "\n0.032000,3,900").error(),
              AllOf(HasSubstr("my/side.csv, line 4"), HasSubstr("gyro.x")));
  EXPECT_THAT(good.withLog("side.csv", "\n0.032000,3,", "\n0.032000,3,x").error(), HasSubstr("my/side.csv, line 4"));
  EXPECT_THAT(good.with("\"up\": [-1, 0, 0]", "\"up\": [-1, 1, 0]").error(), HasSubstr("`logs[2].up`"));
  EXPECT_THAT(good.with("\"up\": [-1, 0, 0], ", "").error(), HasSubstr("`logs[2].up`"));
  EXPECT_THAT(good.with("\"up\": [-1, 0, 0]", "\"up\": [-1, 0]").error(), HasSubstr("`logs[2].up`"));
  EXPECT_THAT(good.with("\"repeat_of\": \"up.csv\"", "\"repeat_of\": \"down.csv\"").error(),
              AllOf(HasSubstr("`logs[1].repeat_of`"), HasSubstr(messages::kRepeatOfNothing)));
  EXPECT_THAT(good.with("\"setup\": \"floor\"", "\"setup\": \"flor\"").error(), HasSubstr("`logs[4].setup`"));
  EXPECT_THAT(good.with("\"role\": \"fit\"", "\"role\": \"other\"").error(),
              AllOf(HasSubstr("`logs[0].role`"), HasSubstr(messages::kOtherOfBody)));
  EXPECT_THAT(good.with("{\"exact\": true}", "{\"servos\": 0.1}").error(),
              AllOf(HasSubstr("`trust.servos`"), HasSubstr("servo")));
  EXPECT_THAT(good.with("floor.csv", "../floor.csv").error(), HasSubstr(messages::kBeyondFolder));
}

TEST(BodyCase, ASideIsTheOneThatTheAccelerometerShows) {
  const std::string clamped = R"("stand_clamped", "up": [-1, 0, 0])";
  const auto lying = [&](const std::string& up) {
    return BodyTexts{}.with(clamped, R"("lying", "up": ")" + up + "\"");
  };
  EXPECT_EQ(lying("side").read().logs[2].lies_on, "left");
  EXPECT_EQ(lying("right").read().logs[2].lies_on, "right") << "as it is written";
  BodyTexts on_right = lying("side");
  on_right.logs["side.csv"] = SyntheticRobot{}.recording({1, 0, 0}, 2);
  EXPECT_EQ(on_right.read().logs[2].lies_on, "right");
  on_right.logs["side.csv"] = SyntheticRobot{}.recording({0, 0, 1}, 2);
  EXPECT_THAT(on_right.error(), AllOf(HasSubstr("side.csv"), HasSubstr(messages::kNoSide)));
}

// Whatever the model says of its axes: that may be what is missing in it.
TEST(BodyCase, ASideIsTheOneThatAClampedLogReadsAlike) {
  SyntheticRobot mirrored;
  mirrored.map = [](const Vector& reading) { return Vector{-reading[0], reading[1], -reading[2]}; };
  BodyTexts texts{mirrored};
  texts = texts.with(R"("setup": "floor")", R"("setup": "lying", "up": "side")");
  texts.logs["floor.csv"] = mirrored.recording({-1, 0, 0}, 2);
  EXPECT_EQ(texts.read().logs[4].lies_on, "left");
  texts.logs["floor.csv"] = mirrored.recording({1, 0, 0}, 2);
  EXPECT_EQ(texts.read().logs[4].lies_on, "right");
}

TEST(BodyCase, APriorOfWhichNothingIsKnownIsLeftOutAndSaid) {
  const BodyCase c =
      BodyTexts{}.with("{\"exact\": true}", R"({"body.mass": 0.03, "imu.bias_rad_s": 0.01, "cable": 0.2})").read();
  EXPECT_EQ(c.sigmaOf("body.mass"), 0.03);
  EXPECT_EQ(c.sigmaOf("imu.gyro_bias_rad_s"), 0.01) << "another name of the same number";
  EXPECT_EQ(c.trust.size(), 2u);
  EXPECT_THAT(c.warnings, ElementsAre(AllOf(HasSubstr("trust.cable"), HasSubstr(messages::kUnknownKey))));
}

TEST(BodyCase, AServoThatIsSilentForLongIsRefused) {
  SyntheticRobot robot;
  BodyTexts texts{robot};
  std::string& log = texts.logs["side.csv"];
  // The position of the first joint, from line 20 on.
  std::size_t at = 0;
  for (int line = 1; line < 20; ++line) at = log.find('\n', at) + 1;
  for (; at < log.size(); at = log.find('\n', at) + 1) {
    std::size_t from = at;
    for (int comma = 0; comma < 11; ++comma) from = log.find(',', from) + 1;
    log.erase(from, log.find(',', from) - from);
  }
  EXPECT_THAT(texts.error(), AllOf(HasSubstr("my/side.csv"), HasSubstr("ShoulderR.position")));
}

TEST(BodyCase, AServoThatAnswersInSomeLogsOnlyIsRefused) {
  BodyTexts texts;
  SyntheticRobot without;
  without.absent_joint = index(Joint::kNeck);
  texts.logs["side.csv"] = without.recording({-1, 0, 0}, 2);
  EXPECT_THAT(texts.error(), HasSubstr(std::string{"side.csv: Neck"} + messages::kSilentInSome));
}

TEST(BodyCase, IsNotReadAsACaseOfOneServo) {
  const BodyTexts texts;
  try {
    (void)parseCase(texts.json, "my/case.json", {});
    FAIL() << "it is read";
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kWholeRobot));
  }
}

TEST(BodyCheck, ReportsWhatIsThere) {
  SyntheticRobot robot;
  robot.limp_joint = index(Joint::kNeck);
  const BodyCase c = BodyTexts{robot}.read();
  const BodyCheck check = checkData(c);
  EXPECT_THAT(check.warnings, IsEmpty());
  EXPECT_THAT(check.cannot_show, IsEmpty());
  EXPECT_EQ(check.orientations, 3u);
  EXPECT_THAT(check.logs[0].limp, ElementsAre("Neck"));
  EXPECT_NEAR(check.logs[0].limp_s, 40 * 0.016, 1e-9);
  EXPECT_NEAR(check.logs[0].duration_s, 159 * 0.016, 1e-9);
  EXPECT_THAT(check.logs[0].unmoved, IsEmpty());
}

TEST(BodyCheck, ReportsWhatIsMissing) {
  BodyTexts texts = BodyTexts{}.with("[-1, 0, 0]", "[0, 1, 0]").with("\"repeat_of\": \"up.csv\", ", "");
  const BodyCheck check = checkData(texts.read());
  EXPECT_EQ(check.orientations, 2u);
  EXPECT_EQ(check.cannot_show.size(), 3u);  // orientations, nothing limp, no repeat
}

TEST(BodyCheck, RowsThatAreLostAreReported) {
  const BodyTexts texts = BodyTexts{}.withLog("face.csv", "\n2.544000,160,", "\n2.576000,162,");
  const BodyCheck check = checkData(texts.read());
  EXPECT_EQ(texts.read().logs[3].lost_rows, 2u);
  EXPECT_EQ(check.logs[3].late_rows, 1u);
  EXPECT_THAT(check.warnings, ElementsAre(HasSubstr("face.csv")));
}

TEST(BodyCase, AFallAndWhatFollowsAreLeftOut) {
  SyntheticRobot robot;
  robot.falls = true;
  const BodyCase fallen = BodyTexts{robot}.read();
  const BodyLog& log = fallen.logs[4];  // on the floor
  ASSERT_TRUE(log.fell_at_s);
  EXPECT_NEAR(*log.fell_at_s, 80 * 0.016, 0.2);
  EXPECT_LT(log.time_s.back(), *log.fell_at_s);
  EXPECT_EQ(log.accel_m_s2[0].size(), log.rows());
  EXPECT_EQ(fallen.joint(4, 0).rows(), log.rows());
  EXPECT_FALSE(fallen.logs[0].fell_at_s);  // clamped
  EXPECT_EQ(fallen.logs[0].rows(), 160u);
  EXPECT_THAT(fallen.warnings, ElementsAre(HasSubstr("floor.csv: the robot falls at 1.")));
  EXPECT_EQ(checkData(fallen).warnings, fallen.warnings);
}

TEST(BodyCheck, AClampedTrunkThatTurnsIsReported) {
  const auto jerk = [](std::size_t row, const std::string& field) { return row == 30 ? "1.5" : field; };
  BodyTexts held;
  for (const char* log : {"side.csv", "floor.csv"})  // on the floor it may
    held.logs[log] = withColumn(held.logs[log], "gyro.y", jerk);
  const BodyCase given = held.read();
  EXPECT_THAT(given.warnings, ElementsAre(AllOf(HasSubstr("side.csv"), HasSubstr(messages::kTrunkShakes))));
  EXPECT_EQ(checkData(given).warnings, given.warnings);
}

}  // namespace
}  // namespace darwinop::gap
