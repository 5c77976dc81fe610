// The Robot itself: names, devices, and how its life ends.
#include <gmock/gmock.h>

#include <webots/Camera.hpp>
#include <webots/Device.hpp>
#include <webots/Motor.hpp>
#include <webots/Node.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Speaker.hpp>

#include "fixture.hpp"
#include "webots/messages.hpp"

namespace darwinop::webots_api {
namespace {

using testing::HasSubstr;

class RobotTest : public Facade {};

TEST_F(RobotTest, SaysWhatItIs) {
  EXPECT_EQ(robot().getName(), "darwin-op");
  EXPECT_EQ(robot().getMode(), webots::Robot::MODE_CROSS_COMPILATION);
  EXPECT_EQ(robot().getBasicTimeStep(), 16);
  EXPECT_EQ(robot().getType(), webots::Node::ROBOT);
  EXPECT_EQ(webots::Robot::getInstance(), &robot());
}

TEST_F(RobotTest, HasEveryDeviceOfTheTable) {
  for (const JointRow& row : kJointTable) {
    EXPECT_NE(robot().getMotor(std::string{row.name}), nullptr) << row.name;
    EXPECT_NE(robot().getPositionSensor(std::string{row.name} + "S"), nullptr) << row.name;
  }
  for (const char* name : {"Accelerometer", "Gyro", "Camera", "EyeLed", "HeadLed", "BackLedRed", "BackLedGreen",
                           "BackLedBlue", "Speaker", "ButtonMode", "ButtonStart"}) {
    ASSERT_NE(robot().getDevice(name), nullptr) << name;
    EXPECT_EQ(robot().getDevice(name)->getName(), name);
  }
}

TEST_F(RobotTest, DevicesHaveDistinctTags) {
  EXPECT_EQ(robot().getNumberOfDevices(), 51);
  for (int i = 0; i < robot().getNumberOfDevices(); ++i) EXPECT_EQ(robot().getDeviceByIndex(i)->getTag(), i + 1);
  EXPECT_EQ(robot().getDeviceByIndex(-1), nullptr);
  EXPECT_EQ(robot().getDeviceByIndex(51), nullptr);
}

TEST_F(RobotTest, AnUnknownNameIsNullAndSaidOnce) {
  robot();
  testing::internal::CaptureStderr();
  EXPECT_EQ(robot().getMotor("Nose"), nullptr);
  EXPECT_EQ(robot().getMotor("Nose"), nullptr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "darwinop: Robot::getMotor(\"Nose\"): this robot has no such device; it returns NULL\n");
}

TEST_F(RobotTest, ANameOfAnotherClassIsNull) {
  EXPECT_EQ(robot().getMotor("NeckS"), nullptr);
  EXPECT_EQ(robot().getLED("Neck"), nullptr);
}

TEST_F(RobotTest, TheEndOfTheRobotEndsTheSession) {
  auto impl = std::make_unique<RobotImpl>(std::make_unique<FakeLink>(fake), config, stop);
  ASSERT_EQ(impl->begin(), "");
  {
    const TestRobot mine{impl.release()};
    EXPECT_FALSE(fake.end_of_session);
  }
  EXPECT_TRUE(fake.end_of_session);
  EXPECT_EQ(webots::Robot::getInstance(), nullptr);
}

TEST_F(RobotTest, ReleasingTheRobotBeforeItsOwnerIsHarmless) {
  auto impl = std::make_unique<RobotImpl>(std::make_unique<FakeLink>(fake), config, stop);
  RobotImpl* const raw = impl.release();
  const TestRobot mine{raw};
  release(raw);  // as at exit()
  EXPECT_TRUE(fake.end_of_session);
}

TEST_F(RobotTest, AUserWhoRequestsTheEndIsInformedWhatTheRobotDoesMeanwhile) {
  const auto notice = [&](safety::OnExit on_exit, bool asked, bool real_time) {
    fake.image.safety.at_end = safety::atExit(on_exit);  // as the loop reports it
    fake.real_time = real_time;
    auto impl = std::make_unique<RobotImpl>(std::make_unique<FakeLink>(fake), config, stop);
    stop = false;
    (void)impl->begin();
    stop = asked;
    testing::internal::CaptureStderr();
    impl.reset();
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(notice(safety::OnExit::kKneel, true, true), "darwinop: " + std::string{messages::kEndsKneeling} + "\n");
  EXPECT_THAT(notice(safety::OnExit::kLimp, true, true), HasSubstr(messages::kEndsLimp));
  EXPECT_THAT(notice(safety::OnExit::kHold, true, true), HasSubstr(messages::kEndsHolding));
  EXPECT_EQ(notice(safety::OnExit::kKneel, false, true), "") << "nobody waits at a terminal";
  EXPECT_EQ(notice(safety::OnExit::kKneel, true, false), "") << "a simulation takes no time";
}

TEST_F(RobotTest, CustomDataIsKept) {
  robot().setCustomData("left_foot");
  EXPECT_EQ(robot().getCustomData(), "left_foot");
}

TEST_F(RobotTest, CallsOfTheSimulatorSayOnceThatTheyDoNothing) {
  robot();
  testing::internal::CaptureStderr();
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(robot().getUrdf(), "");
    EXPECT_EQ(robot().getWorldPath(), "");
    EXPECT_EQ(robot().wwiReceiveText(), "");
    robot().wwiSendText("x");
    robot().setMode(webots::Robot::MODE_SIMULATION, nullptr);
    EXPECT_EQ(robot().waitForUserInputEvent(webots::Robot::EVENT_KEYBOARD, 10), webots::Robot::EVENT_NO_EVENT);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::ranges::count(said, '\n'), 6);
  EXPECT_THAT(said, HasSubstr("Robot::getUrdf()"));
}

}  // namespace
}  // namespace darwinop::webots_api
