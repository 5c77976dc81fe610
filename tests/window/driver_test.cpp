// Who may drive, what reaches the robot, and when it is held.
#include "window/driver.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <stdexcept>
#include <vector>

#include "remote/protocol/units.hpp"

namespace darwinop {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

struct RobotOnPaper final : remote::RobotPort {
  void begin(remote::Beginning) override {
    if (!refusal.empty()) throw std::runtime_error(refusal);
    held = false;
  }
  void obey(const remote::Request& request) override { obeyed.push_back(request); }
  Sensors sensors() override { return {}; }
  std::string mustEnd() override { return end; }
  void hold() noexcept override { held = true; }

  std::string refusal, end;
  bool held = true;
  std::vector<remote::Request> obeyed;
};

struct Page final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane, web::Bytes text) override { heard = *text; }
  void sendBinary(web::Lane, web::Bytes) override {}
  void forgetNewest() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string&) override {}

  std::string heard, who = "page";
};

struct WindowDriver : testing::Test {
  void take() { driver.said(page, R"({"take": true})", false); }

  Nanos now{0};
  RobotOnPaper robot;
  Page page, other;
  window::Driver driver{robot, [this] { return now; }};
};

TEST_F(WindowDriver, NobodyMovesTheRobotBeforeItIsTaken) {
  driver.said(page, R"({"goals": {"Neck": 0.3}})", false);
  driver.turn();
  EXPECT_TRUE(robot.obeyed.empty());
}

TEST_F(WindowDriver, AGoalReachesTheRobotOnceWithASpeed) {
  take();
  EXPECT_THAT(page.heard, HasSubstr(R"("yours":true)"));
  driver.said(page, R"({"goals": {"Neck": 0.1}})", false);
  driver.said(page, R"({"goals": {"Neck": 0.3}})", false);
  driver.turn();
  driver.turn();
  ASSERT_EQ(robot.obeyed.size(), 2U);
  ASSERT_EQ(robot.obeyed[0].motors.size(), 1U);
  const remote::MotorSetting& setting = robot.obeyed[0].motors[0];
  EXPECT_EQ(setting.joint, Joint::kNeck);
  EXPECT_NEAR(remote::positionFromWire(setting.position), 0.3, 0.002);
  EXPECT_NEAR(remote::velocityFromWire(setting.velocity), window::Driver::kFastest, 0.02);
  EXPECT_TRUE(robot.obeyed[1].motors.empty());
}

TEST_F(WindowDriver, AGoalBeyondATurnIsCutToWhatAnEncoderKnows) {
  take();
  driver.said(page, R"({"goals": {"Neck": 1e300, "Head": -9}})", false);
  driver.turn();
  for (const remote::MotorSetting& setting : robot.obeyed.at(0).motors)
    EXPECT_TRUE(remote::isEncoderPosition(setting.position)) << setting.position;
}

TEST_F(WindowDriver, ASecondPageIsRefusedAndMovesNothing) {
  take();
  driver.said(other, R"({"take": true, "goals": {"Neck": 0.3}})", false);
  EXPECT_THAT(other.heard, HasSubstr("another page drives"));
  driver.said(other, R"({"stop": true})", false);
  driver.turn();
  EXPECT_TRUE(robot.obeyed.at(0).motors.empty());
  EXPECT_FALSE(robot.held);
}

TEST_F(WindowDriver, StopSilenceAndFarewellHoldTheRobot) {
  take();
  driver.said(page, R"({"stop": true})", false);
  EXPECT_TRUE(robot.held);

  take();
  EXPECT_FALSE(robot.held);
  now += window::Driver::kPatience;
  driver.turn();
  EXPECT_FALSE(robot.held);
  now += 1ms;
  driver.turn();
  EXPECT_TRUE(robot.held);
  EXPECT_THAT(page.heard, HasSubstr("not heard"));

  take();
  driver.closed(page);
  EXPECT_TRUE(robot.held);
  EXPECT_FALSE(driver.drives());
}

TEST_F(WindowDriver, WhatIsNotUnderstoodIsNoSignOfLife) {
  take();
  now += window::Driver::kPatience;
  for (const char* nonsense : {"", "[]", "{", R"({"take": 1})", R"({"goals": [1]})", R"({"goals": {"Nose": 1}})",
                               R"({"goals": {"Neck": "up"}})", R"({"goals": {"Neck": null}})", "\xff\xfe"}) {
    driver.said(page, nonsense, false);
    EXPECT_THAT(page.heard, testing::Not(HasSubstr(R"("text":"")"))) << nonsense;
  }
  driver.said(page, "{}", true);
  now += 1ms;
  driver.turn();
  EXPECT_TRUE(robot.held);
}

TEST_F(WindowDriver, ARefusedLeaseAndAFaultAreToldInWords) {
  robot.refusal = "another controller drives";
  take();
  EXPECT_THAT(page.heard, HasSubstr("another controller drives"));
  EXPECT_FALSE(driver.drives());
  robot.refusal.clear();
  take();
  robot.end = "the supply is under 10.0 V";
  driver.turn();
  EXPECT_TRUE(robot.held);
  EXPECT_THAT(page.heard, HasSubstr("under 10.0 V"));
}

}  // namespace
}  // namespace darwinop
