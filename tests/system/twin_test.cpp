// The physics twin as a user meets it: real programs, in lockstep and on a pty.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <set>

#include "system/rig.hpp"
#include "virtual_robot_report.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

constexpr double kDriven = 4;  // safety.state
constexpr double kFell = 30;   // safety.fault

/// What a recording says of the time in which the controller drove.
class Drive {
 public:
  explicit Drive(const std::string& file) : log_{file} {
    for (std::size_t i = 0; i < log_.rows(); ++i)
      if (log_.at(i, "safety.state") == kDriven) rows_.push_back(i);
  }
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] double at(std::size_t row, const std::string& column) const { return log_.at(rows_.at(row), column); }
  [[nodiscard]] double atSecond(double second, const std::string& column) const {
    return at(static_cast<std::size_t>(second / 0.016), column);
  }
  /// Without the cycles in which it was not read.
  [[nodiscard]] std::vector<double> read(const std::string& column) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < rows(); ++i)
      if (const double value = at(i, column); !std::isnan(value)) values.push_back(value);
    return values;
  }
  [[nodiscard]] double range(const std::string& column) const {
    const auto [low, high] = std::ranges::minmax(read(column));
    return high - low;
  }
  [[nodiscard]] double change(const std::string& column) const {
    const std::vector<double> values = read(column);
    return values.back() - values.front();
  }
  /// Of the trunk against the vertical, rad.
  [[nodiscard]] double tilt(std::size_t row) const {
    const auto accel = [&](const char* axis) { return at(row, std::string{"accelerometer."} + axis + " [m/s2]"); };
    return std::atan2(std::hypot(accel("x"), accel("y")), accel("z"));
  }
  [[nodiscard]] double tiltAtSecond(double second) const { return tilt(static_cast<std::size_t>(second / 0.016)); }

 private:
  Recording log_;
  std::vector<std::size_t> rows_;
};

std::string position(const std::string& joint) {
  return joint + ".position [rad]";
}

/// In the second half of the drive: the right knee bends to over 1.2 rad; standing 0.93, in the air 1.47.
int stepsIn(const Drive& drive) {
  const std::vector<double> knee = drive.read(position("LegLowerR"));
  int bends = 0;
  for (std::size_t i = knee.size() / 2; i < knee.size(); ++i) bends += knee[i - 1] < 1.2 && knee[i] >= 1.2 ? 1 : 0;
  return bends;
}

constexpr std::array<const char*, 12> kLegs{"PelvYR",    "PelvYL",    "PelvR",  "PelvL",  "LegUpperR", "LegUpperL",
                                            "LegLowerR", "LegLowerL", "AnkleR", "AnkleL", "FootR",     "FootL"};
constexpr std::array<const char*, 8> kArmsAndHead{"ShoulderR", "ShoulderL", "ArmUpperR", "ArmUpperL",
                                                  "ArmLowerR", "ArmLowerL", "Neck",      "Head"};

class OnTheTwin : public Rig {
 protected:
  /// `darwinop run`, to its normal end.
  std::string runOn(const std::string& robot, const std::vector<std::string>& command, const std::string& log = "") {
    std::vector<std::string> all{program("darwinop-run"), "--robot", robot};
    if (!log.empty()) all.insert(all.end(), {"--record", file(log)});
    all.insert(all.end(), command.begin(), command.end());
    Program running{all, file("run.txt")};
    EXPECT_EQ(running.wait(seconds{60}), 0) << running.output();
    return running.output();
  }
  std::unique_ptr<Program> twinOnAPort(const std::string& board = "cm-730") {
    auto robot = std::make_unique<Program>(std::vector<std::string>{program("darwinop-virtual-robot"), "--body", "twin",
                                                                    "--link", port(), "--board", board},
                                           file("virtual-robot.txt"));
    EXPECT_TRUE(robot->says("link:", seconds{10})) << robot->output();
    return robot;
  }
};

TEST_F(OnTheTwin, SymmetryMovesTheSameJointsTheSameWayInLockstepAndOverThePty) {
  const std::vector<std::string> symmetry{DARWINOP_SYMMETRY, "--seconds", "6"};
  runOn("twin", symmetry, "lockstep.csv");
  const auto robot = twinOnAPort();
  runOn(port(), symmetry, "pty.csv");
  robot->kill(SIGTERM);
  EXPECT_EQ(robot->wait(seconds{10}), 0);
  EXPECT_THAT(robot->output(), HasSubstr(app::kBehindRealTime));

  const Drive lockstep{file("lockstep.csv")}, pty{file("pty.csv")};
  ASSERT_GT(lockstep.rows(), 300U);
  ASSERT_GT(pty.rows(), 300U);
  std::vector<const char*> joints(kLegs.begin(), kLegs.end());
  joints.insert(joints.end(), kArmsAndHead.begin(), kArmsAndHead.end());
  std::set<std::string> moved;
  // The arms swing at up to 3 rad/s, and in real time a command or a reading may come three cycles (48 ms) later.
  constexpr double kLate = 0.15;  // rad
  for (const std::string joint : joints) {
    const std::string column = position(joint);
    EXPECT_NEAR(lockstep.range(column), pty.range(column), kLate) << joint;
    EXPECT_NEAR(lockstep.change(column), pty.change(column), kLate) << joint;
    if (std::abs(lockstep.change(column)) > 0.2) moved.insert(joint);
  }
  EXPECT_THAT(moved, testing::UnorderedElementsAre("ShoulderR", "ShoulderL", "ArmUpperR", "ArmUpperL", "ArmLowerR",
                                                   "ArmLowerL"));
  // The limp right arm hangs, and the left one is its mirror image: P without load stops short by less than 0.05 rad.
  for (const std::string joint : {"Shoulder", "ArmUpper", "ArmLower"})
    EXPECT_NEAR(pty.read(position(joint + "L")).back(), -pty.read(position(joint + "R")).back(), 0.05) << joint;
  // And at the same time.
  for (std::size_t i = 0; i < std::min(lockstep.rows(), pty.rows()); i += 10) {
    const double here = lockstep.at(i, position("ShoulderR")), there = pty.at(i, position("ShoulderR"));
    if (!std::isnan(here) && !std::isnan(there)) {
      ASSERT_NEAR(here, there, kLate) << i << " cycles after the start";
    }
  }
}

TEST_F(OnTheTwin, TheVirtualRobotReportsItsTrunkOnlyIfItsBodyHasOne) {
  const auto twin = twinOnAPort();
  twin->kill(SIGUSR1);
  EXPECT_TRUE(twin->says(" m\n", seconds{10})) << twin->output();
  EXPECT_THAT(twin->output(), HasSubstr(" rad trunk_x="));
  EXPECT_THAT(twin->output(), HasSubstr(" trunk_z=+0.2"));  // 0.2 m: kneeling

  Program plain{{program("darwinop-virtual-robot"), "--link", file("plain")}, file("plain.txt")};
  ASSERT_TRUE(plain.says("body:", seconds{10})) << plain.output();
  plain.kill(SIGUSR1);
  EXPECT_TRUE(plain.says(" rad\n", seconds{10})) << plain.output();
  EXPECT_THAT(plain.output(), testing::Not(HasSubstr("trunk")));
}

TEST_F(OnTheTwin, ARobotInTheStartPoseWithAllTorqueOffStaysThere) {
  const std::string output = runOn("twin", {DARWINOP_LIMP_CONTROLLER}, "log.csv");
  EXPECT_THAT(output, HasSubstr("20 motors are limp"));
  EXPECT_THAT(output, testing::Not(HasSubstr("fault 30")));

  const Drive log{file("log.csv")};
  ASSERT_GT(log.rows(), 600U);  // 9.6 s
  for (const char* joint : kLegs) {
    const std::vector<double> torque = log.read(std::string{joint} + ".torque_enabled");
    ASSERT_GT(torque.size(), 10U) << joint;
    EXPECT_THAT(std::vector<double>(torque.begin() + 2, torque.end()), testing::Each(0)) << joint;
    // Play and the sag of soles are below 0.03 rad; a robot that sits down or tips moves its hips by over half a rad.
    EXPECT_LT(log.range(position(joint)), 0.1) << joint;
  }
  // Arms and head hang down, as on a desk. The trunk leans forward as it did before, and nothing jolts.
  for (std::size_t i = 0; i < log.rows(); i += 10) ASSERT_NEAR(log.tilt(i), log.tilt(0), 0.1) << i;
  EXPECT_LT(log.tilt(0), 0.35) << "20 deg is what the check of the start pose allows";
  EXPECT_LT(log.range("accelerometer.z [m/s2]"), 2) << "a fifth of g: the arms swing to rest";
}

TEST_F(OnTheTwin, ARobotThatStandsAndReleasesTorqueFallsAndTheSafetyLayerReportsIt) {
  const std::string output = runOn("twin", {DARWINOP_STANDING_CONTROLLER}, "log.csv");
  EXPECT_THAT(output, HasSubstr("stood"));
  EXPECT_THAT(output, HasSubstr("fault 30 fell"));

  const Drive log{file("log.csv")};
  ASSERT_GT(log.rows(), 495U);  // 7.92 s
  EXPECT_LT(log.tiltAtSecond(4.9), 0.25) << "it stands: the feet would leave the floor at more";
  EXPECT_NEAR(log.atSecond(4.9, position("LegLowerR")), 0, 0.1) << "with straight knees";
  EXPECT_EQ(log.atSecond(4.9, "safety.fault"), 0);
  EXPECT_GT(log.tiltAtSecond(7.9), 1.0) << "lying";
  EXPECT_EQ(log.atSecond(7.9, "safety.fault"), kFell);
}

TEST_F(OnTheTwin, TheExampleWalksOverThePtyInRealTimeAndStandsBehindEachBoard) {
  for (const char* const board : {"cm-730", "cm-740"}) {
    SCOPED_TRACE(board);
    const auto robot = twinOnAPort(board);
    const std::string log = std::string{board} + ".csv";
    const std::string output = runOn(port(), {DARWINOP_WALK, "--seconds", "3"}, log);
    EXPECT_THAT(output, testing::Not(HasSubstr("fault 30")));
    EXPECT_GE(stepsIn(Drive{file(log)}), 4) << "a step every 0.6 s";
  }
}

TEST_F(OnTheTwin, TheExampleWalksWithServosAlone) {
  const auto robot = twinOnAPort("none");
  std::ofstream{file("robot.ini")} << "[Robot]\nboard = none\n";
  setenv("DARWINOP_ROBOT_FILE", file("robot.ini").c_str(), 1);
  runOn(port(), {DARWINOP_WALK, "--seconds", "3"}, "log.csv");
  unsetenv("DARWINOP_ROBOT_FILE");
  const Drive log{file("log.csv")};
  EXPECT_GE(stepsIn(log), 4) << "a step every 0.6 s";
  EXPECT_TRUE(log.read("accelerometer.z [m/s2]").empty());
  EXPECT_TRUE(log.read("board.servo_power").empty());
}

TEST_F(OnTheTwin, AFallIsReportedByTheStatusOfTheDaemon) {
  const auto robot = twinOnAPort();
  const Program daemon{{program("darwinop-runtime"), "--robot", port()}, file("daemon.txt")};
  ASSERT_TRUE(daemon.says("ready:", seconds{20})) << daemon.output();
  runOn("runtime", {DARWINOP_STANDING_CONTROLLER});
  Program asking{{program("darwinop-runtime"), "--status"}, file("status.txt")};
  EXPECT_EQ(asking.wait(seconds{10}), 0);
  EXPECT_THAT(asking.output(), HasSubstr("30 fell"));
}

TEST_F(OnTheTwin, AModelThatIsNotThereEndsAllProgramsWithTheSentenceThatNamesTheOthers) {
  const std::vector<std::pair<std::vector<std::string>, int>> commands{
      {{program("darwinop-run"), "--robot", "twin:missing", controller()}, 1},  // the controller's status
      {{program("darwinop-virtual-robot"), "--body", "twin:missing"}, 2}};
  for (const auto& [command, status] : commands) {
    Program running{command, file("run.txt")};
    EXPECT_EQ(running.wait(seconds{20}), status);
    EXPECT_THAT(running.output(), HasSubstr("webots-2013")) << command.front();
  }
}

}  // namespace
}  // namespace darwinop
