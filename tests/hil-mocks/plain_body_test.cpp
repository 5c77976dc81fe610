// Motion of the plain body.
#include "hil-mocks/plain_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/conversions.hpp"

namespace darwinop::hil {
namespace {

using namespace std::chrono_literals;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

Drives allTo(double goal_rad, double speed = kNoLimit) {
  Drives drives;
  drives.fill({.torque_on = true, .goal_rad = goal_rad, .speed_limit_rad_s = speed, .torque_limit = 1.0});
  return drives;
}

const JointMotion& neck(const PlainBody& body) {
  return body.state().joint[index(Joint::kNeck)];
}

void run(PlainBody& body, const Drives& drives, Nanos time) {
  for (Nanos t{0}; t < time; t += 2ms) body.step(2ms, drives);
}

TEST(PlainBody, StartsInTheStartPoseUprightAndAtRest) {
  const PlainBody body;
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_EQ(ticksFromRad(Rad{body.state().joint[i].position_rad}), kJointTable[i].start);
    EXPECT_EQ(body.state().joint[i].velocity_rad_s, 0);
  }
  EXPECT_DOUBLE_EQ(body.state().accel_m_s2[2], 9.80665);
}

TEST(PlainBody, EveryJointReachesItsGoalWithinATickWithIndividualOffsets) {
  PlainBody body;
  run(body, allTo(0.5), 3s);
  int exact = 0;
  for (const JointMotion& joint : body.state().joint) {
    EXPECT_NEAR(joint.position_rad, 0.5, 1.01 * kRadPerTick);
    exact += std::abs(joint.position_rad - 0.5) < 0.1 * kRadPerTick ? 1 : 0;
  }
  EXPECT_EQ(exact, 7);
}

TEST(PlainBody, KeepsTheSpeedLimit) {
  PlainBody body;
  const double limit = 1.0;
  double fastest = 0;
  for (int i = 0; i < 1500; ++i) {
    body.step(2ms, allTo(1.5, limit));
    for (const JointMotion& joint : body.state().joint) fastest = std::max(fastest, std::abs(joint.velocity_rad_s));
  }
  EXPECT_LE(fastest, limit * 1.001);
  EXPECT_GE(fastest, limit * 0.95) << "and reaches it";
}

TEST(PlainBody, IsNeverFasterThanTheNoLoadSpeed) {
  PlainBody body;
  body.place(Joint::kNeck, -3);
  double fastest = 0;
  for (int i = 0; i < 500; ++i) {
    body.step(2ms, allTo(3));
    fastest = std::max(fastest, neck(body).velocity_rad_s);
  }
  EXPECT_LE(fastest, 55 * 2 * kPi / 60);
  EXPECT_GE(fastest, 0.9 * 55 * 2 * kPi / 60);
}

TEST(PlainBody, LimpJointCoastsToRest) {
  PlainBody body;
  body.place(Joint::kNeck, 0);
  run(body, allTo(1.5), 100ms);
  const double velocity = neck(body).velocity_rad_s, position = neck(body).position_rad;
  ASSERT_GT(velocity, 1);
  run(body, Drives{}, 100ms);
  EXPECT_LT(neck(body).velocity_rad_s, velocity);
  EXPECT_GT(neck(body).velocity_rad_s, 0.5 * velocity) << "coasting";
  EXPECT_GT(neck(body).position_rad, position + 0.05);
  EXPECT_EQ(neck(body).load, 0);
  run(body, Drives{}, 10s);
  EXPECT_NEAR(neck(body).velocity_rad_s, 0, 1e-6);
}

TEST(PlainBody, TorqueEnableStartsAtThePresentPositionWithTheSpeedLimit) {
  PlainBody body;
  body.place(Joint::kNeck, 0);
  run(body, allTo(1.5), 100ms);
  run(body, Drives{}, 5s);
  const double before = neck(body).position_rad;
  run(body, allTo(0, 0.5), 100ms);
  EXPECT_NEAR(neck(body).position_rad, before - 0.05, 0.03);
}

TEST(PlainBody, WithoutTorqueLimitItDoesNotMove) {
  PlainBody body;
  Drives drives = allTo(1.0);
  for (ServoDrive& drive : drives) drive.torque_limit = 0;
  const double before = neck(body).position_rad;
  run(body, drives, 1s);
  EXPECT_EQ(neck(body).position_rad, before);
}

TEST(PlainBody, LoadHasTheSignOfTheTorque) {
  PlainBody body;
  body.place(Joint::kNeck, 0);
  run(body, allTo(1.0), 10ms);
  EXPECT_GT(neck(body).load, 0.1);
  body.place(Joint::kNeck, 0);
  run(body, allTo(-1.0), 10ms);
  EXPECT_LT(neck(body).load, -0.1);
}

TEST(PlainBody, StaysWithinTheEncodersRange) {
  PlainBody body;
  run(body, allTo(10), 5s);
  for (const JointMotion& joint : body.state().joint) EXPECT_LE(joint.position_rad, kPi);
}

TEST(PlainBody, HighGainAndCoarseStepsStayFinite) {
  PlainBody body;
  Drives drives = allTo(1.0);
  for (ServoDrive& drive : drives) drive.p_gain = 254 / 8.0;
  for (int i = 0; i < 500; ++i) body.step(8ms, drives);
  for (const JointMotion& joint : body.state().joint) EXPECT_LT(std::abs(joint.position_rad), 4);
}

}  // namespace
}  // namespace darwinop::hil
