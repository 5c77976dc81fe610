// A joint of a robot that lacks servos or the board.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <sstream>

#include "gap/case/case.hpp"
#include "gap/case/robot/joint_case.hpp"
#include "gap/case/robot/recorded_swing.hpp"
#include "twin/body/pendulum.hpp"

namespace darwinop::gap {
namespace {

using IncompleteRobot = Folder;

// As with `board = none` in robot.ini. The servo reports its voltage.
TEST_F(IncompleteRobot, OfARobotWithoutABoardIsUprightWithTheVoltageOfTheServo) {
  std::istringstream lines{recordedSwing()};
  std::string all, none;
  for (std::string line; std::getline(lines, line);) {
    if (std::isdigit(line.front()) != 0) {
      const std::size_t board = line.find(',', line.find(',') + 1);
      std::size_t end = board;
      for (int column = 0; column < 4; ++column) end = line.find(',', end + 1);
      all += line + "\n";
      line.replace(board, end - board, ",,,,");
      none += line + "\n";
    } else {
      all += line + "\n", none += line + "\n";
    }
  }
  std::ofstream{file("swing.csv")} << none;
  const std::vector<std::string> said =
      writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("case")).logs;
  EXPECT_THAT(said, testing::ElementsAre(testing::AllOf(testing::HasSubstr(messages::kTakenAsUpright),
                                                        testing::HasSubstr(messages::kSupplyOfModel))));
  for (std::size_t at = none.find(",,30\n"); at != none.npos; at = none.find(",,30\n", at + 1))
    none.replace(at, 5, ",10.7,30\n");
  std::ofstream{file("swing.csv")} << none;
  writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("with"));
  EXPECT_NEAR(readCase(file("with")).model.servo.supply_v, 10.7, 1e-9);
  std::ofstream{file("swing.csv")} << all;
  writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("board"));
  EXPECT_NEAR(readCase(file("with")).logs[0].payload_kg, readCase(file("board")).logs[0].payload_kg, 0.002);
}

// As `absent` of robot.ini, or with a broken cable.
TEST_F(IncompleteRobot, DoesNotDependOnServosOfOtherLimbs) {
  std::map<std::string, Case> made;
  for (const auto& [of, silent] : {std::pair{"all", std::optional<Joint>{}}, {"no_neck", Joint::kNeck}}) {
    std::ofstream{file("swing.csv")} << recordedSwing(0, silent);
    writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file(of));
    made[of] = readCase(file(of));
  }
  const Trajectory &all = made["all"].logs.at(0), &no_neck = made["no_neck"].logs.at(0);
  EXPECT_EQ(no_neck.position_rad, all.position_rad);
  EXPECT_NEAR(no_neck.payload_kg, all.payload_kg, 1e-12);
  EXPECT_NEAR(made["no_neck"].pendulum.length_m, made["all"].pendulum.length_m, 1e-12);
  std::ofstream{file("no_elbow.csv")} << recordedSwing(0, Joint::kArmLowerR);
  try {
    writeJointCase({.recordings = {file("no_elbow.csv")}, .held_out = {}}, file("case"));
    ADD_FAILURE() << "the angle of the elbow is in the weight of the arm";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(std::string{"ArmLowerR"} + twin::messages::kAngleUnknown));
  }
}

}  // namespace
}  // namespace darwinop::gap
