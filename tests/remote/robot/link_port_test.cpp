// LinkPort: requests become commands; also on a virtual robot in simulated time.
#include "remote/robot/link_port.hpp"

#include <gtest/gtest.h>

#include "connect/connect.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::remote {
namespace {

/// A link that exposes published commands and takes sensors from the test.
struct WatchedLink final : runtime::RobotLink {
  std::shared_ptr<std::vector<Commands>> published;
  std::shared_ptr<Sensors> seen;
  WatchedLink(std::shared_ptr<std::vector<Commands>> log, std::shared_ptr<Sensors> sensors)
      : published{std::move(log)}, seen{std::move(sensors)} {}
  Nanos period() const override { return std::chrono::milliseconds{16}; }
  Nanos now() const override { return Nanos{0}; }
  bool realTime() const override { return false; }
  void publish(Commands commands) override { published->push_back(commands); }
  bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>&) override {
    seen->cycle = std::max(seen->cycle, cycle);
    return true;
  }
  Sensors sensors() const override { return *seen; }
  std::string whyEnded() const override { return {}; }
};

struct PortOfAWatchedLink {
  std::shared_ptr<std::vector<Commands>> published = std::make_shared<std::vector<Commands>>();
  std::shared_ptr<Sensors> seen = std::make_shared<Sensors>();
  LinkPort port{LinkPort::Home::kEmbedded, [this] { return std::make_unique<WatchedLink>(published, seen); }, false};

  PortOfAWatchedLink() {
    seen->safety.state = State::kDriven;
    port.startSession(SessionStart::kNew);
  }
  const Commands& apply(const Request& request) {
    port.apply(request);
    return published->back();
  }
  const JointCommand& neck(const MotorSetting& setting) {
    Request request;
    (void)request.motors.add(setting);
    return apply(request).joint[index(Joint::kNeck)];
  }
};

TEST(RemoteLinkPort, ARequestForSensorsCommandsNoJoint) {
  PortOfAWatchedLink robot;
  const Commands& asked = robot.apply({});
  for (const JointCommand& joint : asked.joint) EXPECT_EQ(joint.set, 0);
  EXPECT_EQ(asked.led, LedCommand{});
}

TEST(RemoteLinkPort, KeepsCommandsUntilTheyChange) {
  PortOfAWatchedLink robot;
  (void)robot.neck({.joint = Joint::kNeck,
                    .set = MotorSetting::kPosition | MotorSetting::kVelocity | MotorSetting::kPid,
                    .position = 325,
                    .velocity = 125,
                    .pid = {10000, 0, 0}});
  const JointCommand& neck = robot.apply({}).joint[index(Joint::kNeck)];
  EXPECT_NEAR(neck.goal.value, 0.49854, 5e-6);
  EXPECT_NEAR(neck.speed_limit.value, 1.4923, 1e-4);
  EXPECT_EQ(neck.p_gain, 10);
}

TEST(RemoteLinkPort, IgnoresAPositionOutsideTheEncodersRange) {
  PortOfAWatchedLink robot;
  EXPECT_FALSE(robot.neck({.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = kNoValue})
                   .has(JointCommand::kGoal));
}

TEST(RemoteLinkPort, ZeroAvailableTorqueMeansLimp) {
  PortOfAWatchedLink robot;
  const JointCommand& limp = robot.neck({.joint = Joint::kNeck, .set = MotorSetting::kAvailableTorque});
  EXPECT_TRUE(limp.has(JointCommand::kTorque));
  EXPECT_FALSE(limp.torque_on);
  const JointCommand& stiff =
      robot.neck({.joint = Joint::kNeck, .set = MotorSetting::kAvailableTorque, .available_torque = 511});
  EXPECT_TRUE(stiff.torque_on);
  EXPECT_NEAR(stiff.torque_limit.value, 1.2488, 1e-4);
}

TEST(RemoteLinkPort, SetsTheEyeAndBackLeds) {
  PortOfAWatchedLink robot;
  robot.seen->board.led_panel = 2;
  Request request;
  (void)request.leds.add({Led::kEye, 0xFF0000});
  (void)request.leds.add({Led::kBackRed, 1});
  (void)request.leds.add({Led::kBackGreen, 0x10000});
  const Commands& asked = robot.apply(request);
  EXPECT_EQ(asked.led.eye, 31);
  EXPECT_EQ(asked.led.panel, 1 | 2) << "blue stays as the board shows it, green is on for exactly 1 only";
}

TEST(RemoteLinkPort, HoldsASlowJointAtItsPosition) {
  PortOfAWatchedLink robot;
  (void)robot.neck({.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = 652});
  JointSensors& neck = robot.seen->joint[index(Joint::kNeck)];
  neck.motion.received();
  neck.position = Rad{0.3};
  neck.commanded = Rad{1.0};
  JointSensors& head = robot.seen->joint[index(Joint::kHead)];
  head = neck;
  head.commanded = Rad{0.35};
  robot.port.hold();
  EXPECT_EQ(robot.published->back().joint[index(Joint::kNeck)].goal, Rad{0.3});
  EXPECT_EQ(robot.published->back().joint[index(Joint::kHead)].goal, Rad{0.35}) << "a joint at rest must not sag";
}

TEST(RemoteLinkPort, HoldsWhereItIsDuringTheMoveToTheStartPose) {
  PortOfAWatchedLink robot;
  (void)robot.neck({.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = 652});
  robot.seen->safety.state = State::kStarting;
  robot.seen->joint[index(Joint::kNeck)].commanded = Rad{0.4};
  robot.port.hold();
  EXPECT_TRUE(robot.published->back().hold);
  EXPECT_EQ(robot.published->back().joint[index(Joint::kNeck)].goal, Rad{0.4}) << "1 rad was the client's";
}

TEST(RemoteLinkPort, StartsEachNewClientWithoutEarlierCommands) {
  PortOfAWatchedLink robot;
  (void)robot.neck({.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = 325});
  robot.port.hold();
  robot.port.startSession(SessionStart::kResumed);
  EXPECT_TRUE(robot.apply({}).joint[index(Joint::kNeck)].has(JointCommand::kGoal)) << "the same one keeps them";
  EXPECT_TRUE(robot.published->back().start_where_it_is);
  robot.port.hold();
  robot.port.startSession(SessionStart::kNew);
  EXPECT_EQ(robot.apply({}).joint[index(Joint::kNeck)].set, 0);
  EXPECT_FALSE(robot.published->back().start_where_it_is);
}

TEST(RemoteLinkPort, ResumedSessionsAreUnattendedAndNewOnesAreNot) {
  PortOfAWatchedLink robot;
  EXPECT_FALSE(robot.apply({}).unattended);
  robot.port.hold();
  robot.port.startSession(SessionStart::kResumed);
  EXPECT_TRUE(robot.apply({}).unattended);
  robot.port.hold();
  robot.port.startSession(SessionStart::kNew);
  EXPECT_FALSE(robot.apply({}).unattended);
  Request request;
  request.extended = request.extension.unattended = true;
  EXPECT_TRUE(robot.apply(request).unattended);
}

Request untilCycle(std::uint64_t cycle) {
  Request request;
  request.extended = true;
  request.extension.until_cycle = cycle;
  return request;
}

TEST(RemoteLinkPort, RunsToTheRequestedCycleInSimulatedTime) {
  PortOfAWatchedLink robot;
  (void)robot.apply(untilCycle(0));
  EXPECT_EQ(robot.seen->cycle, 0) << "whatever time has gone by";
  (void)robot.apply(untilCycle(5));
  EXPECT_EQ(robot.seen->cycle, 5);
  (void)robot.apply(untilCycle(1'000'000));
  EXPECT_EQ(robot.seen->cycle, 5 + 500 / 16) << "half a second at once, or the server would not answer";
}

TEST(RemoteLinkPort, AppliesStartWhereItIsAndEndOfSessionOfTheExtension) {
  PortOfAWatchedLink robot;
  Request request = untilCycle(1);
  request.extension.start_where_it_is = true;
  request.extension.fault_resets = 3;
  EXPECT_TRUE(robot.apply(request).start_where_it_is);
  EXPECT_EQ(robot.published->back().fault_resets, 3);
  robot.port.endSession();
  EXPECT_TRUE(robot.published->back().end_of_session);
  robot.port.startSession(SessionStart::kNew);
  EXPECT_FALSE(robot.apply({}).end_of_session);
}

TEST(RemoteLinkPort, DrivesAVirtualRobot) {
  connect::ConnectRequest virtual_robot;
  virtual_robot.setting = "virtual";
  LinkPort port{LinkPort::Home::kEmbedded, [&] { return connect::connect(virtual_robot); }, true};
  port.startSession(SessionStart::kNew);
  Request request;
  (void)request.motors.add({.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = 325});
  const auto neck = [&] { return port.sensors().joint[index(Joint::kNeck)].position.value; };
  for (int i = 0; i < 400 && !(std::abs(neck() - 0.49854) < 0.002); ++i) port.apply(request);
  EXPECT_NEAR(neck(), 0.49854, 0.002);
  EXPECT_EQ(port.endReason(), "");
  const std::uint32_t first_session = port.sensors().safety.session;
  port.hold();
  port.startSession(SessionStart::kNew);
  for (int i = 0; i < 100; ++i) port.apply({});
  EXPECT_NE(port.sensors().safety.session, first_session) << "safety starts each client as gently as the first one";
  EXPECT_NEAR(neck(), 0.49854, 0.002) << "with a new client it starts at its present position, as configured";
}

}  // namespace
}  // namespace darwinop::remote
