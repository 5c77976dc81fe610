// Directions of a stand that are off, readings that are missing, and held-out logs that contradict the fitted ones: of
// recordings that the test writes.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "gap/body/synthetic_robot.hpp"
#include "gap/case/body/body_check.hpp"
#include "gap/identify/body/body_identification.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kHalfDegree = 0.5 * kPi / 180;
const std::string kPhysical = R"({"imu.gyro_bias_rad_s": 0.05, "imu.accel_bias_m_s2": 0.3)";

/// Each placement is off by half a degree about another axis than was declared.
BodyCase inACrookedStand(const SyntheticRobot& robot) {
  BodyCase given = BodyTexts{robot}.read();
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    BodyLog& log = given.logs[i];
    if (!log.up) continue;
    const double way = 2.0 * static_cast<double>(log.repeat_of.value_or(i));
    const Eigen::Vector3d up{(*log.up)[0], (*log.up)[1], (*log.up)[2]}, any{0.3, 0.5, -0.8};
    const Eigen::Vector3d about = Eigen::AngleAxisd{way, up} * up.cross(any).normalized();
    const Eigen::Vector3d off = Eigen::AngleAxisd{kHalfDegree, about} * up;
    log.up = Axes{off[0], off[1], off[2]};
  }
  return given;
}

std::vector<std::string_view> sensorNames(const BodyIdentification& answer) {
  std::vector<std::string_view> ids;
  for (const SensorSelection& one : answer.sensors)
    for (const SensorEffect* const effect : one.found.effects) ids.push_back(effect->id);
  return ids;
}

TEST(RestingStand, ADirectionThatIsOffByHalfADegreeHasNoName) {
  SyntheticRobot robot;
  robot.trust = kPhysical + "}";
  EXPECT_GT(identify(inACrookedStand(robot), BodyScope::kSensors).table.open(), 0u) << "a direction that is exact";
  robot.trust = kPhysical + R"(, "up_rad": 0.01})";
  const BodyIdentification answer = identify(inACrookedStand(robot), BodyScope::kSensors);
  EXPECT_EQ(answer.verdict, Verdict::kCannotTell);
  EXPECT_THAT(sensorNames(answer), IsEmpty());
  EXPECT_EQ(answer.table.open(), 0u);
}

TEST(RestingStand, WhatIsBeyondTheErrorsOfTheStandStillHasItsName) {
  SyntheticRobot turned, swapped;
  turned.yaw_rad = 0.05;
  swapped.map = [](const Vector& reading) { return Vector{-reading[1], reading[0], reading[2]}; };
  turned.trust = swapped.trust = kPhysical + R"(, "up_rad": 0.01})";
  EXPECT_THAT(sensorNames(identify(inACrookedStand(turned), BodyScope::kSensors)), ElementsAre("imu_mounting"));
  EXPECT_THAT(sensorNames(identify(inACrookedStand(swapped), BodyScope::kSensors)), ElementsAre("accel_axes"));
}

// Two recordings of one placement show its error twice, and it is no more likely a sensor's.
TEST(RestingStand, ARepeatInTheSamePlacementAddsNoEvidenceAgainstTheStand) {
  SyntheticRobot robot;
  robot.trust = R"({"up_rad": 0.01})";
  BodyCase given = BodyTexts{robot}.read();
  for (BodyLog& log : given.logs)
    if (log.up && (*log.up)[1] == 1) log.up = Axes{std::sin(0.025), std::cos(0.025), 0};
  const auto significance = [&] {
    const BodyTable table = localize(given, RestingImu{given.joints.model});
    return std::ranges::find(table.rows, "accelerometer.x", &BodyRow::signal)->significance;
  };
  const double repeated = significance();
  for (BodyLog& log : given.logs) log.repeat_of.reset();
  EXPECT_GT(significance(), repeated + 0.5);
}

TEST(RestingStand, AnEffectThatAHeldOutLogContradictsHasNoName) {
  SyntheticRobot biased;
  biased.accel_bias = {0, -0.3, 0.1};
  BodyTexts texts{biased};
  ASSERT_THAT(sensorNames(identify(texts.read(), BodyScope::kSensors)), ElementsAre("accel_bias"));
  texts.logs["tilt.csv"] = SyntheticRobot{}.recording({0.48, 0.6, 0.64}, 5);
  const BodyIdentification answer = identify(texts.read(), BodyScope::kSensors);
  EXPECT_THAT(sensorNames(answer), IsEmpty());
  EXPECT_EQ(answer.verdict, Verdict::kUnknown);
  EXPECT_LE(answer.held_out.after.accel, answer.held_out.before.accel);
}

/// Without the readings of these columns in this log.
void forget(AxesColumns& columns, std::initializer_list<std::size_t> axes) {
  for (const std::size_t axis : axes) std::ranges::fill(columns[axis], std::nan(""));
}

TEST(RestingStand, AnAxisWithoutReadingsIsReportedAndTheOthersAreUsed) {
  SyntheticRobot robot;
  robot.accel_bias = {0, -0.3, 0};
  BodyCase given = BodyTexts{robot}.read();
  forget(given.logs[2].accel_m_s2, {0});
  const BodyCheck check = checkData(given);
  EXPECT_EQ(check.orientations, 3u);
  EXPECT_THAT(check.cannot_show, Contains(AllOf(HasSubstr("side.csv"), HasSubstr("accelerometer.x"))));
  EXPECT_EQ(restingReadings(given, ImuSensor::kAccelerometer).size(), 4u);
  EXPECT_THAT(sensorNames(identify(given, BodyScope::kSensors)), ElementsAre("accel_bias"));
}

TEST(RestingStand, WithoutAnyReadingNothingOfTheSensorIsShownOrTested) {
  BodyCase given = BodyTexts{}.read();
  for (BodyLog& log : given.logs) forget(log.accel_m_s2, {0, 1, 2}), forget(log.gyro_rad_s, {1});
  const BodyCheck check = checkData(given);
  EXPECT_EQ(check.orientations, 0u);
  EXPECT_THAT(check.cannot_show,
              Contains(AllOf(HasSubstr("up.csv"), HasSubstr("gyro.y"), HasSubstr("accelerometer.z"))));
  const BodyTable table = localize(given, RestingImu{given.joints.model});
  EXPECT_THAT(table.not_tested, Contains(AllOf(HasSubstr("gyro.y"), HasSubstr("accelerometer.z"))));
}

}  // namespace
}  // namespace darwinop::gap
