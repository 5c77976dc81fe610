// What controllers written for the simulator find on this robot: every member compiles, absent devices are reported
// once.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <utility>
#include <webots/Camera.hpp>
#include <webots/GPS.hpp>
#include <webots/Joystick.hpp>
#include <webots/Keyboard.hpp>
#include <webots/Motor.hpp>
#include <webots/Mouse.hpp>
#include <webots/Supervisor.hpp>
#include <webots/TouchSensor.hpp>

#include "api/today/every_member/EveryMember.hpp"
#include "fixture.hpp"
#include "webots/messages.hpp"

namespace darwinop::webots_api {
namespace {

using testing::HasSubstr;

/// As controllers of supervisors do it.
class TestSupervisor : public webots::Supervisor {
 public:
  explicit TestSupervisor(RobotImpl* impl) : Supervisor(impl) {}
};

class AbsentDevicesTest : public Facade {
 protected:
  /// What `action` logs, after the robot was made.
  template <class Action>
  std::string logged(Action action) {
    robot();
    testing::internal::CaptureStderr();
    action();
    return testing::internal::GetCapturedStderr();
  }
};

/// One line on stderr.
std::string line(const std::string& text) {
  return "darwinop: " + text + "\n";
}

/// All but the speaker, which would play.
void useEverything(webots::Supervisor& supervisor) {
  useRobot(&supervisor);
  useMotors(&supervisor);
  useSensors(&supervisor);
  useCamera(&supervisor);
  useInputs(&supervisor);
  useAbsentSensors(&supervisor);
  useAbsentActuators(&supervisor);
  useWorld(&supervisor);
}

TEST_F(AbsentDevicesTest, AControllerThatUsesEveryMemberRuns) {
  TestSupervisor supervisor{makeImpl()};
  useEverything(supervisor);
  EXPECT_EQ(supervisor.step(16), 0);
}

TEST_F(AbsentDevicesTest, OnTheVirtualRobotEveryMemberIsUsedTwiceAndNoLineIsRepeated) {
  setenv("DARWINOP_ROBOT", "virtual", 1);
  setenv("DARWINOP_KEEP_CWD", "1", 1);
  setenv("DARWINOP_KEYS", "none", 1);
  webots::Supervisor supervisor;
  testing::internal::CaptureStderr();
  useEverything(supervisor);
  useEverything(supervisor);
  EXPECT_EQ(supervisor.step(16), 0);
  std::istringstream log{testing::internal::GetCapturedStderr()};
  std::map<std::string, int> times;
  for (std::string text; std::getline(log, text);) ++times[text];
  const auto is_logged = [&times](const std::string& call) {
    return std::ranges::any_of(times, [&](const auto& row) { return row.first.find(call) != std::string::npos; });
  };
#define ROW(CLASS) EXPECT_TRUE(is_logged("get" #CLASS "(") && is_logged(" " #CLASS "(\"own\")")) << #CLASS;
  DARWINOP_ABSENT_DEVICES(ROW)
#undef ROW
  for (const auto& [text, count] : times) EXPECT_EQ(count, 1) << text;
  for (const char* name : {"DARWINOP_ROBOT", "DARWINOP_KEEP_CWD", "DARWINOP_KEYS"}) unsetenv(name);
}

TEST_F(AbsentDevicesTest, ADeviceOfAnotherRobotIsNullAndReportedOncePerName) {
  using Getter = const void* (*)(const webots::Robot&, const std::string&);
#define ROW(CLASS)                                                                                       \
  std::pair<const char*, Getter>{"get" #CLASS, [](const webots::Robot& robot, const std::string& name) { \
                                   return static_cast<const void*>(robot.get##CLASS(name));              \
                                 }},
  const std::vector<std::pair<const char*, Getter>> getters{DARWINOP_ABSENT_DEVICES(ROW)};
#undef ROW
  ASSERT_FALSE(getters.empty());
  for (const auto& [call, get] : getters) {
    const std::string log = logged([&, get = get] {
      for (const char* name : {"front", "front", "back", "front"}) EXPECT_EQ(get(robot(), name), nullptr);
    });
    const std::string start = "Robot::" + std::string{call};
    EXPECT_EQ(log, line(start + "(\"front\")" + messages::kNoSuchDevice) +
                       line(start + "(\"back\")" + messages::kNoSuchDevice));
  }
}

TEST_F(AbsentDevicesTest, AJoystickIsNeverConnected) {
  EXPECT_EQ(logged([&] {
              webots::Joystick own;
              own.enable(16);
              webots::Joystick* const joystick = robot().getJoystick();
              ASSERT_NE(joystick, nullptr);
              joystick->enable(32);
              EXPECT_EQ(joystick->getSamplingPeriod(), 32);
              EXPECT_FALSE(joystick->isConnected());
              EXPECT_EQ(joystick->getNumberOfAxes(), 0);
              EXPECT_EQ(joystick->getPressedButton(), -1);
            }),
            line(messages::kNoJoystick));
}

TEST_F(AbsentDevicesTest, AMouseIsNeverInTheWindow) {
  EXPECT_EQ(logged([&] {
              webots::Mouse own;
              own.enable(16);
              webots::Mouse* const mouse = robot().getMouse();
              ASSERT_NE(mouse, nullptr);
              mouse->enable(32);
              const webots::MouseState state = mouse->getState();
              EXPECT_FALSE(state.left || state.middle || state.right);
              EXPECT_TRUE(std::isnan(state.u) && std::isnan(state.v));
              EXPECT_TRUE(std::isnan(state.x) && std::isnan(state.y) && std::isnan(state.z));
            }),
            line(messages::kNoMouse));
}

TEST_F(AbsentDevicesTest, ACameraRecognisesNothing) {
  EXPECT_EQ(logged([&] {
              webots::Camera* const camera = robot().getCamera("Camera");
              EXPECT_FALSE(camera->hasRecognition());
              camera->recognitionEnable(32);
              camera->enableRecognitionSegmentation();
              EXPECT_EQ(camera->getRecognitionNumberOfObjects(), 0);
              EXPECT_EQ(camera->getRecognitionObjects(), nullptr);
              EXPECT_EQ(camera->getRecognitionSegmentationImage(), nullptr);
              EXPECT_EQ(camera->saveRecognitionSegmentationImage("segments.png", 100), -1);
            }),
            line(messages::kNoRecognition));
}

TEST_F(AbsentDevicesTest, AButtonHasNoThreeAxes) {
  EXPECT_EQ(logged([&] {
              webots::TouchSensor* const button = robot().getTouchSensor("ButtonStart");
              EXPECT_EQ(button->getValues(), nullptr);
              EXPECT_EQ(button->getValues(), nullptr);
              EXPECT_EQ(button->getLookupTableSize(), 0);
            }),
            line(messages::kNoThreeAxes));
}

TEST_F(AbsentDevicesTest, ASupervisorDrivesTheRobotAndFindsNoWorld) {
  TestSupervisor supervisor{makeImpl()};
  EXPECT_EQ(webots::Supervisor::getSupervisorInstance(), &supervisor);
  EXPECT_FALSE(supervisor.getSupervisor());
  testing::internal::CaptureStderr();
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(supervisor.getFromDef("BALL"), nullptr);
    EXPECT_EQ(supervisor.getSelf(), nullptr);
    supervisor.simulationReset();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            line(std::string{"Supervisor::getFromDef()"} + messages::kNoSceneTree) +
                line(std::string{"Supervisor::getSelf()"} + messages::kNoSceneTree) +
                line(std::string{"Supervisor::simulationReset()"} + messages::kNoSceneTree));
  supervisor.getMotor("Neck")->setPosition(0.2);
  ASSERT_EQ(supervisor.step(16), 0);
  EXPECT_NEAR(fake.last().joint[index(Joint::kNeck)].goal.value, 0.2, 0.001);
}

TEST_F(AbsentDevicesTest, ARobotIsNotTheSupervisor) {
  robot();
  EXPECT_EQ(webots::Supervisor::getSupervisorInstance(), nullptr);
}

TEST_F(AbsentDevicesTest, AKeyboardOfTheControllersOwnIsTheRobots) {
  held = {'A'};
  webots::Keyboard keyboard;
  robot();
  keyboard.enable(16);
  EXPECT_EQ(robot().getKeyboard()->getSamplingPeriod(), 16);
  ASSERT_EQ(robot().step(16), 0);
  EXPECT_EQ(keyboard.getKey(), 'A');
  EXPECT_EQ(robot().getKeyboard()->getKey(), -1) << "each key is read once";
  robot().getKeyboard()->enable(32);
  EXPECT_EQ(keyboard.getSamplingPeriod(), 32);
  EXPECT_EQ(keys_opened, 1);
  keyboard.disable();
  EXPECT_EQ(robot().getKeyboard()->getSamplingPeriod(), 0);
}

TEST_F(AbsentDevicesTest, AKeyboardWithoutARobotHasNoKeys) {
  testing::internal::CaptureStderr();
  webots::Keyboard keyboard;
  keyboard.enable(16);
  EXPECT_EQ(keyboard.getKey(), -1);
  EXPECT_EQ(keyboard.getSamplingPeriod(), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), line(messages::kKeyboardWithoutRobot));
}

TEST_F(AbsentDevicesTest, AnglesAreWrittenInDegreesMinutesAndSeconds) {
  EXPECT_EQ(webots::GPS::convertToDegreesMinutesSeconds(12.5), "12° 30′ 0″");
}

}  // namespace
}  // namespace darwinop::webots_api
