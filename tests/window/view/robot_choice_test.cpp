// Selection of the robot: invalid combinations are reported before anything is started.
#include "window/view/robot_choice.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "runtime/messages.hpp"

namespace darwinop {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using window::RobotChoice;

template <class Act>
std::string whyNot(Act act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(WindowRobotChoice, StartsAControllerOnlyOnItsOwnRobot) {
  for (const RobotChoice& choice :
       {RobotChoice{.robot = "runtime"}, RobotChoice{.robot = "tcp://r"}, RobotChoice{.monitor = "r:5024"}}) {
    EXPECT_EQ(window::startSimulatedRobot(choice, {}), nullptr) << choice.robot;
    EXPECT_THAT(whyNot([&] { (void)window::startSimulatedRobot(choice, {"walker"}); }), HasSubstr("darwinop run"));
  }
  EXPECT_THAT(whyNot([] { (void)window::startSimulatedRobot({.robot = "twins"}, {}); }),
              AllOf(HasSubstr("twins"), HasSubstr("twin:MODEL")));
  EXPECT_THAT(whyNot([] { (void)window::startSimulatedRobot({.robot = "/dev/ttyUSB0"}, {}); }),
              HasSubstr("darwinop runtime --robot /dev/ttyUSB0"));
}

// The twin of such a window would run without a controller.
TEST(WindowRobotChoice, AControllerThatIsNotThereIsReportedBeforeARobotStarts) {
  for (const char* robot : {"twin", "virtual"})
    EXPECT_THAT(whyNot([&] { (void)window::startSimulatedRobot({.robot = robot}, {"nothere"}); }),
                HasSubstr(std::string{runtime::messages::kNoSuchController} + "nothere"));
}

TEST(WindowRobotChoice, ARuntimeThatDoesNotRunIsSeen) {
  const runtime::RuntimeFiles nowhere{"/nowhere"};
  EXPECT_TRUE(window::hasNoRuntimeYet({.robot = "runtime"}, nowhere));
  EXPECT_FALSE(window::hasNoRuntimeYet({.robot = "twin"}, nowhere));
  EXPECT_FALSE(window::hasNoRuntimeYet({.robot = "runtime", .monitor = "r:5024"}, nowhere));
}

TEST(WindowRobotChoice, ObservesOnlyWithAMonitorAlone) {
  const runtime::RuntimeFiles no_daemon{"/nowhere"};
  const RobotChoice looks{.monitor = "127.0.0.1:1"};
  EXPECT_THAT(whyNot([&] { (void)window::openDriveLink(looks, no_daemon, {}); }), HasSubstr("tcp://HOST"));
}

}  // namespace
}  // namespace darwinop
