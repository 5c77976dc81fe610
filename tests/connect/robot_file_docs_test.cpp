// docs/robot-file.md and the file that is installed say what the code does.
#include <gmock/gmock.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <string>

#include "connect/robot_file.hpp"
#include "safety/layers.hpp"

namespace darwinop::connect {
namespace {

std::string contents(const char* path) {
  std::ifstream file{path};
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>{file}, {}};
}

std::string winner(std::string_view setting) {
  for (const safety::StricterRow& rule : safety::kStricterWins) {
    if (rule.name != setting) continue;
    if (rule.wins == safety::Stricter::kMode) return "`mode`";
    return rule.wins == safety::Stricter::kLower ? "the lower" : "the higher";  // no message
  }
  return "config.ini";
}

TEST(RobotFileDocs, ThePageHasTheTableOfWhoWins) {
  std::string rows;
  safety::Config{}.visit([&](std::string_view name, const auto&...) {
    rows += "| `" + std::string{name} + "` | " + winner(name) + " |\n";
  });
  EXPECT_THAT(contents(DARWINOP_ROBOT_FILE_PAGE), testing::HasSubstr(rows)) << "put this table there:\n" << rows;
}

TEST(InstalledRobotFile, IsSoundAndChangesNothing) {
  const RobotFile robot = parseRobotFile(contents(DARWINOP_INSTALLED_ROBOT_FILE), "robot.ini");
  EXPECT_EQ(robot.port, kRobotsPort);
  EXPECT_EQ(robot.camera, "/dev/video0");
  EXPECT_EQ(robot.period, kUsualPeriod);
  EXPECT_EQ(robot.group, "");
  EXPECT_EQ(robot.controller_user, "");
  EXPECT_TRUE(robot.safety.named.none());
  EXPECT_EQ(safety::numbers(safetyOn(robot, {}, "config.ini")), safety::numbers(safety::Config{}));
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_EQ(robot.offsets.ticks(static_cast<Joint>(i)), 0);
}

TEST(InstalledRobotFile, HasALineForTheOffsetOfEveryJoint) {
  const std::string text = contents(DARWINOP_INSTALLED_ROBOT_FILE);
  for (const JointRow& joint : kJointTable)
    EXPECT_THAT(text, testing::HasSubstr("\n" + std::string{joint.name} + " = 0.000\n"));
}

/// What follows a # without a blank is a setting that waits for the # to go.
TEST(InstalledRobotFile, ItsCommentedSettingsAreSoundAndTheDefaults) {
  std::string text = contents(DARWINOP_INSTALLED_ROBOT_FILE);
  for (std::size_t at = text.find("\n#"); at != text.npos; at = text.find("\n#", at + 1))
    if (std::isalpha(static_cast<unsigned char>(text[at + 2])) != 0) text.erase(at + 1, 1);
  const RobotFile robot = parseRobotFile(text, "robot.ini");
  EXPECT_GE(robot.safety.named.count(), 4U);
  safety::Config settings = robot.safety;
  settings.range = safety::hardRanges();
  EXPECT_EQ(safety::numbers(settings), safety::numbers(safety::Config{}));
}

}  // namespace
}  // namespace darwinop::connect
