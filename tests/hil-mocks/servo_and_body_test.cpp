// Values that a virtual servo takes from a body with electrical and thermal state.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bench.hpp"
#include "hil-mocks/virtual_robot.hpp"

namespace darwinop::hil {
namespace {

constexpr std::uint8_t kTemperature = 43, kVoltage = 42, kTorqueEnable = 24, kTorqueLimit = 34;
const std::string kNeckGoal = withChecksum("FF FF 13 05 03 1E 60 09");
const std::string kNeckPingText = withChecksum("FF FF 13 02 01");
const std::string kNeckFullTorque = withChecksum("FF FF 13 05 03 22 FF 03");

/// Reports the given state of its neck and records the drive command.
class FakeBody final : public Body {
 public:
  void step(Nanos, const Drives& drives) noexcept override { drives_ = drives; }
  [[nodiscard]] const BodyState& state() const noexcept override { return state_; }
  [[nodiscard]] const char* error() const noexcept override { return error_; }
  void end(const char* why) { error_ = why; }
  [[nodiscard]] JointMotion& neck() { return state_.joint[index(Joint::kNeck)]; }
  [[nodiscard]] const ServoDrive& drive() const { return drives_[index(Joint::kNeck)]; }

 private:
  BodyState state_;
  Drives drives_;
  const char* error_ = nullptr;
};

class ServoOnABody : public ::testing::Test {
 protected:
  ServoOnABody() {
    auto made = std::make_unique<FakeBody>();
    body = made.get();
    robot = std::make_unique<VirtualRobot>(Bench::powered(), 1, std::move(made));
  }
  /// Reply within 20 ms.
  std::string send(const std::string& hex) {
    robot->receive(bytesOf(hex), robot->now());
    wait(20ms);
    std::string all;
    for (ChunkRing& out = robot->output(); !out.empty(); out.pop()) all += hexOf(out.front().bytes());
    return all;
  }
  void wait(Nanos time) { robot->advance(robot->now() + time); }
  [[nodiscard]] const ControlTable& neck() const { return robot->board().servo(Joint::kNeck).table(); }

  FakeBody* body = nullptr;
  std::unique_ptr<VirtualRobot> robot;
};

TEST_F(ServoOnABody, ReportsTheBodysTemperatureAndSupply) {
  body->neck().temperature_c = 47.4;
  body->neck().supply_v = 11.24;
  wait(10ms);
  EXPECT_EQ(neck().byte(kTemperature), 47);
  EXPECT_EQ(neck().byte(kVoltage), 112);
}

TEST_F(ServoOnABody, UsesTheBoardsSettingsWithoutValuesOfTheBody) {
  wait(10ms);
  EXPECT_EQ(neck().byte(kTemperature), 30);
  EXPECT_EQ(neck().byte(kVoltage), 118);
}

TEST_F(ServoOnABody, AHeatFaultOverridesTheBodyForAsLongAsItLasts) {
  body->neck().temperature_c = 41;
  InjectedFault heat;
  heat.kind = FaultKind::kHeat;
  heat.joints.set(index(Joint::kNeck));
  heat.amount = 70;
  heat.lasts = 100ms;
  robot->faults().add(heat);
  wait(50ms);
  EXPECT_EQ(neck().byte(kTemperature), 70);
  wait(100ms);
  EXPECT_EQ(neck().byte(kTemperature), 41);
}

TEST_F(ServoOnABody, AVoltageFaultSuppliesTheBody) {
  InjectedFault low;
  low.kind = FaultKind::kVoltage;
  low.amount = 9.5;
  robot->faults().add(low);
  wait(10ms);
  EXPECT_DOUBLE_EQ(body->drive().supply_v, 9.5);
}

TEST_F(ServoOnABody, AFailedBodySilencesTheRobotAndIsReportedOnce) {
  EXPECT_NE(send(kNeckPingText), "");
  testing::internal::CaptureStderr();
  body->end("the physics came to an end");
  wait(50ms);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "darwinop: the physics came to an end\n");
  EXPECT_EQ(send(kNeckPingText), "");
}

TEST_F(ServoOnABody, GoalAccelerationReachesTheBody) {
  send(kNeckGoal);
  EXPECT_EQ(body->drive().accel_limit_rad_s2, std::numeric_limits<double>::infinity());
  send(withChecksum("FF FF 13 04 03 49 0A"));
  EXPECT_NEAR(body->drive().accel_limit_rad_s2, 10 * 8.583 * kPi / 180, 1e-12);  // 8.583 deg/s2 per unit (manual)
  send(withChecksum("FF FF 13 04 03 49 00"));
  EXPECT_EQ(body->drive().accel_limit_rad_s2, std::numeric_limits<double>::infinity());
}

TEST_F(ServoOnABody, AnOverloadCutsTorqueAndItsBitStaysUntilTheTorqueLimitIsWritten) {
  send(kNeckGoal);
  EXPECT_TRUE(body->drive().torque_on);
  body->neck().overload = true;
  wait(10ms);
  EXPECT_EQ(neck().word(kTorqueLimit), 0);
  EXPECT_EQ(neck().byte(kTorqueEnable), 0);
  EXPECT_FALSE(body->drive().torque_on);

  body->neck().overload = false;  // no load while limp
  wait(1s);
  EXPECT_EQ(send(kNeckPingText), withChecksum("FF FF 13 02 20"));
  send(kNeckFullTorque);
  EXPECT_EQ(send(kNeckPingText), withChecksum("FF FF 13 02 00"));
  EXPECT_FALSE(body->drive().torque_on) << "torque must be enabled again";
}

TEST_F(ServoOnABody, AnOverloadThatIsNotInTheShutdownMaskIsReportedOnly) {
  send(withChecksum("FF FF 13 04 03 12 04"));
  send(kNeckGoal);
  body->neck().overload = true;
  EXPECT_EQ(send(kNeckPingText), withChecksum("FF FF 13 02 20"));
  EXPECT_TRUE(body->drive().torque_on);
  body->neck().overload = false;
  EXPECT_EQ(send(kNeckPingText), withChecksum("FF FF 13 02 00"));
}

TEST_F(ServoOnABody, OverheatingOfTheBodyCutsTorque) {
  send(kNeckGoal);
  body->neck().temperature_c = 80.6;  // the limit in register 11 is 80
  wait(10ms);
  EXPECT_EQ(neck().word(kTorqueLimit), 0);
  EXPECT_FALSE(body->drive().torque_on);
  EXPECT_EQ(send(kNeckPingText), withChecksum("FF FF 13 02 04"));
}

}  // namespace
}  // namespace darwinop::hil
