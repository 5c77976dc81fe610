// Effects of a resting inertial sensor, from recordings that the test writes.
#include <gmock/gmock.h>

#include "gap/body/synthetic_robot.hpp"
#include "gap/identify/body/body_identification.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

BodyIdentification answerTo(const SyntheticRobot& robot) {
  return identify(BodyTexts{robot}.read(), BodyScope::kSensors);
}

std::vector<std::string_view> idsIn(const BodyIdentification& answer) {
  std::vector<std::string_view> ids;
  for (const SensorSelection& one : answer.sensors)
    for (const SensorEffect* const effect : one.found.effects) ids.push_back(effect->id);
  return ids;
}

const SensorSelection& ofAccelerometer(const BodyIdentification& answer) {
  return *std::ranges::find(answer.sensors, ImuSensor::kAccelerometer, &SensorSelection::sensor);
}

TEST(BodyIdentify, ARobotLikeItsModelIsNotCalledRightBecauseNotAllIsTested) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SyntheticRobot robot;
    robot.seed = seed;
    const BodyIdentification answer = answerTo(robot);
    EXPECT_EQ(answer.verdict, Verdict::kCannotTell) << "seed " << seed;
    EXPECT_THAT(idsIn(answer), IsEmpty());
  }
}

TEST(BodyIdentify, ABiasOfTheGyroscope) {
  SyntheticRobot robot;
  robot.gyro_bias = {0.12, 0, -0.05};
  const BodyIdentification answer = answerTo(robot);
  EXPECT_EQ(answer.verdict, Verdict::kNamed);
  ASSERT_THAT(idsIn(answer), ElementsAre("gyro_bias"));
  const SensorSelection& gyro = answer.sensors.front();
  EXPECT_NEAR(gyro.found.deviation.bias[0], 0.12, 0.01);
  EXPECT_NEAR(gyro.found.deviation.bias[1], 0, 0.01);
  EXPECT_NEAR(gyro.found.deviation.bias[2], -0.05, 0.01);
  EXPECT_GT(answer.held_out.before.gyro, 2 * answer.held_out.floor.gyro);
  EXPECT_NEAR(answer.held_out.after.gyro / answer.held_out.floor.gyro, 1, 0.1);
}

TEST(BodyIdentify, ABiasThatThePriorAllowsHasNoName) {
  SyntheticRobot robot;
  robot.gyro_bias = {0.03, 0, -0.03};
  robot.accel_bias = {0, 0.06, -0.05};
  robot.trust = R"({"imu.gyro_bias_rad_s": 0.03, "imu.accel_bias_m_s2": 0.05})";
  EXPECT_EQ(answerTo(robot).verdict, Verdict::kCannotTell);
}

TEST(BodyIdentify, BiasScaleAxesAndMountingOfTheAccelerometerAreToldApartByThreeOrientations) {  // keep-word
  SyntheticRobot biased, scaled, turned, swapped;
  biased.accel_bias = {0, -0.3, 0.1};
  scaled.accel_scale = {1, 0.95, 1};
  turned.yaw_rad = -0.06;
  swapped.map = [](const Vector& reading) { return Vector{-reading[1], reading[0], reading[2]}; };
  EXPECT_THAT(idsIn(answerTo(biased)), ElementsAre("accel_bias"));
  const BodyIdentification scale = answerTo(scaled), mounting = answerTo(turned), axes = answerTo(swapped);
  EXPECT_THAT(idsIn(scale), ElementsAre("accel_scale"));
  EXPECT_NEAR(ofAccelerometer(scale).found.deviation.scale[1], 0.95, 0.002);
  EXPECT_THAT(idsIn(mounting), ElementsAre("imu_mounting"));
  EXPECT_NEAR(ofAccelerometer(mounting).found.deviation.rotation[2], -0.06, 0.002);
  EXPECT_NEAR(ofAccelerometer(mounting).found.deviation.rotation[0], 0, 0.002);
  EXPECT_THAT(idsIn(axes), ElementsAre("accel_axes"));
  EXPECT_THAT(ofAccelerometer(axes).found.map, ElementsAre(-2, 1, 3));
  EXPECT_EQ(ofAccelerometer(axes).found.maps_alike, 1u);
  for (const auto* answer : {&scale, &mounting, &axes}) EXPECT_EQ(answer->verdict, Verdict::kNamed);
}

TEST(BodyIdentify, TwoEffectsOfOneSensor) {
  SyntheticRobot robot;
  robot.accel_bias = {0.4, 0, 0};
  robot.accel_scale = {1, 1, 1.05};
  EXPECT_THAT(idsIn(answerTo(robot)), UnorderedElementsAre("accel_bias", "accel_scale"));
}

TEST(BodyIdentify, OneOrientationLeavesItAmbiguous) {
  SyntheticRobot robot;
  robot.accel_scale = {1, 1, 1.05};
  BodyCase c = BodyTexts{robot}.read();
  for (BodyLog& log : c.logs)
    if (log.up && (*log.up)[1] != 1) log.setup = BodySetup::kFloor, log.up.reset();
  const BodyIdentification answer = identify(c, BodyScope::kSensors);
  EXPECT_EQ(answer.verdict, Verdict::kAmbiguous);
  std::vector<std::string_view> ids = idsIn(answer);
  for (const SensorFit& rival : ofAccelerometer(answer).rivals) ids.push_back(rival.effects.front()->id);
  EXPECT_THAT(ids, testing::IsSupersetOf({"accel_bias", "accel_scale"}));
  EXPECT_THAT(asText(answer), testing::HasSubstr("darwinop gap plan"));
  const nlohmann::ordered_json json = asJson(c, answer);
  ASSERT_EQ(json["ambiguity"].size(), 1u);  // one group of alternatives
  EXPECT_GE(json["ambiguity"][0].size(), 2u);
}

TEST(BodyIdentify, WhatNoEffectOfASensorExplainsIsUnknown) {
  SyntheticRobot robot;
  robot.duty = [](std::size_t joint, double duty) { return joint == index(Joint::kHead) ? 0.6 * duty : duty; };
  const BodyIdentification answer = answerTo(robot);
  EXPECT_EQ(answer.verdict, Verdict::kUnknown);
  EXPECT_THAT(idsIn(answer), IsEmpty());
}

TEST(BodyIdentify, ANamedEffectKeepsItsNameBesideARemainder) {
  SyntheticRobot robot;
  robot.gyro_bias = {0.12, 0, 0};
  robot.duty = [](std::size_t joint, double duty) { return joint == index(Joint::kHead) ? 0.6 * duty : duty; };
  const BodyCase c = BodyTexts{robot}.read();
  const BodyIdentification answer = identify(c, BodyScope::kSensors);
  EXPECT_EQ(answer.verdict, Verdict::kNamed);
  const nlohmann::ordered_json json = asJson(c, answer);
  EXPECT_EQ(json["effects"][0]["id"], "gyro_bias");
  EXPECT_EQ(json["remainder"]["signals"], nlohmann::ordered_json::array({"Head.load"}));
  EXPECT_TRUE(json["gap_score_before"]["joints_mrad"].is_null()) << "not computed is not zero";
}

}  // namespace
}  // namespace darwinop::gap
