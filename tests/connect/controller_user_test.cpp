// Who drives on a robot, and whose group may use the runtime.
#include "connect/controller_user.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace darwinop::connect {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct ControllerUser : ::testing::Test {
  TemporaryFolder folder;
  runtime::UserFiles robot{folder / "passwd", folder / "group"}, pc{folder / "passwd-pc", folder / "group-pc"};
  void SetUp() override {
    std::ofstream{robot.passwd} << "darwinop:x:998:997::/:/bin/false\nstudent:x:1000:1000::/home/student:/bin/sh\n";
    std::ofstream{robot.group} << "darwinop:x:997:\nstudents:x:1005:\nvideo:x:44:darwinop\n";
    std::ofstream{pc.passwd} << "student:x:1000:1000::/home/student:/bin/sh\n";
    std::ofstream{pc.group} << "students:x:1005:\n";
  }
  static RobotFile says(const std::string& lines) { return parseRobotFile("[Robot]\n" + lines, "robot.ini"); }
};

TEST_F(ControllerUser, IsTheOneThatTheInstallerMade) {
  const auto account = controllerAccount(says(""), robot);
  ASSERT_TRUE(account);
  EXPECT_EQ(account->uid, 998U);
  EXPECT_THAT(account->groups, ElementsAre(997U, 44U));
}

TEST_F(ControllerUser, IsInTheGroupThatMayUseTheRuntimeWhateverItIs) {
  EXPECT_THAT(controllerAccount(says("group = students"), robot)->groups, ElementsAre(997U, 44U, 1005U));
  EXPECT_EQ(controllerAccount(says("controller_user = student\n"), robot)->groups.back(), 997U);
}

TEST_F(ControllerUser, RootIsOnlyForWhoAsksForIt) {
  EXPECT_FALSE(defaultControllerAccount(says("controller_user = root"), robot));
  EXPECT_TRUE(defaultControllerAccount(says(""), robot));
  try {
    (void)defaultControllerAccount(says(""), pc);
    FAIL() << "a default controller would run as root";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no user darwinop"));
    EXPECT_THAT(error.what(), HasSubstr("controller_user = root"));
  }
}

TEST_F(ControllerUser, AComputerWithoutTheUserIsAsItWas) {
  EXPECT_FALSE(controllerAccount(says(""), pc));
  EXPECT_EQ(runtimeGroup(says(""), std::nullopt, pc), static_cast<gid_t>(-1));
}

TEST_F(ControllerUser, AUserThatDoesNotExistIsReported) {
  EXPECT_THROW((void)controllerAccount(says("controller_user = nobody-like-this"), robot), std::runtime_error);
}

TEST_F(ControllerUser, TheRuntimesGroupIsTheirsUnlessAnotherIsNamed) {
  EXPECT_EQ(runtimeGroup(says(""), std::nullopt, robot), 997U);
  EXPECT_EQ(runtimeGroup(says("group = students"), std::nullopt, robot), 1005U);
  EXPECT_EQ(runtimeGroup(says("group = students"), "video", robot), 44U);
  EXPECT_EQ(runtimeGroup(says("group = students"), "", robot), static_cast<gid_t>(-1)) << "--group '' means none";
  EXPECT_THROW((void)runtimeGroup(says("group = nothing"), std::nullopt, robot), std::runtime_error);
}

}  // namespace
}  // namespace darwinop::connect
