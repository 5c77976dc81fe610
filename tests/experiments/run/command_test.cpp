// darwinop experiment: output, refusals, exit status.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiment_run.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/run/recorded.hpp"
#include "experiments/run/shortfalls.hpp"
#include "support/shell.hpp"
#include "system/program.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;
using testing::Not;

class Command : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "darwinop-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    setenv("DARWINOP_RUNTIME_NAME", (folder_ / "runtime").c_str(), 1);
    unsetenv("DARWINOP_ROBOT");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs the command; the output is in `output`.
  int experiment(std::vector<std::string> words) {
    words.insert(words.begin(), std::string{DARWINOP_BIN} + "/darwinop-experiment");
    Program program{words, file("out.txt")};
    const int status = program.wait(std::chrono::seconds{20}).value_or(-1);
    output = program.output();
    return status;
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::ostringstream all;
    all << std::ifstream{file(name)}.rdbuf();
    return all.str();
  }

  std::filesystem::path folder_;
  std::string output;
};

TEST_F(Command, ListsTheSuiteWithTheMovedJoints) {
  EXPECT_EQ(experiment({"list"}), 0);
  EXPECT_THAT(output, HasSubstr("speed\n  Duration of half a turn of the head at six speeds, thesis 5.3.1\n"
                                "  Neck -1.571 to 1.571 rad\n"));
  EXPECT_THAT(output, HasSubstr(experiments::messages::kFallsInList));
}

TEST_F(Command, RunRecordsUnderTheNameOfTheExperiment) {
  EXPECT_EQ(experiment({"run", "chirp", "--robot", "virtual", "--record", file("log.csv")}), 0) << output;
  EXPECT_THAT(output, HasSubstr(experiments::kRecorded + file("log.csv")));
  const std::string log = text("log.csv");
  EXPECT_THAT(log, HasSubstr("\n# experiment: chirp\n# title: The stretched arm"));
  EXPECT_THAT(log, HasSubstr("\n# joints: ShoulderR\n"));
  EXPECT_TRUE(log.ends_with("# end\n"));
}

TEST_F(Command, RunsWithinTheSameSecondLeaveARecordingEach) {
  std::ofstream{file("nod.ini")} << "[experiment]\nname = nod\ntitle = a nod\n[setup]\npose = start\nduration = 1 s\n"
                                    "[phase nod]\njoints = Head\ngoal = step\nto = 0.1 rad\nvelocity = 1 rad/s\n"
                                    "duration = 1 s\n[record]\njoints = Head\n";
  const std::string run = DARWINOP_BIN "/darwinop-experiment run nod.ini --robot virtual";
  const Outcome all =
      shell("cd " + folder_.string() + " && for i in 1 2 3 4; do " + run + " || exit; done; ls nod-*.csv | wc -l");
  EXPECT_EQ(all.status, 0) << all.said;
  EXPECT_TRUE(all.said.ends_with("\n4\n")) << all.said;
}

// Its size limit stands for a full disk. The shared memory of the loop is a file also, which has to fit.
TEST_F(Command, AnExperimentThatCouldNotBeRecordedInFullFails) {
  const std::string limited = "trap '' XFSZ; ulimit -f 1024; exec \"$0\" \"$@\"";
  Program program{{"/bin/bash", "-c", limited, std::string{DARWINOP_BIN} + "/darwinop-experiment", "run", "chirp",
                   "--robot", "virtual", "--record", file("log.csv")},
                  file("out.txt")};
  EXPECT_EQ(program.wait(std::chrono::seconds{20}), 1);
  EXPECT_THAT(program.output(), HasSubstr(experiments::kRecordedInPart + file("log.csv")));
  EXPECT_THAT(program.output(), HasSubstr(std::strerror(EFBIG)));
  EXPECT_THAT(program.output(), Not(HasSubstr(experiments::kRecorded)));
}

TEST_F(Command, ARecordingThatCannotBeWrittenMovesNothing) {
  EXPECT_EQ(experiment({"run", "chirp", "--robot", "virtual", "--record", file("none/log.csv")}), 2);
  EXPECT_THAT(output, HasSubstr(std::strerror(ENOENT)));
}

TEST_F(Command, SuggestsTheClosestNameForAnUnknownOne) {
  EXPECT_EQ(experiment({"show", "sped"}), 2);
  EXPECT_THAT(output, HasSubstr("did you mean speed?"));
}

TEST_F(Command, NamesTheFileThatAUserMayMean) {
  std::ofstream{file("nod.ini")} << "[experiment]\n";
  const Outcome refused = shell("cd " + folder_.string() + " && " DARWINOP_BIN "/darwinop-experiment run nod");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr(std::string{experiments::messages::kOwnExperiment} + "nod.ini\n"));
}

TEST_F(Command, GoalBeyondALimitMovesNothing) {
  std::ofstream{file("far.ini")} << "[experiment]\nname = far\ntitle = too far\n[setup]\npose = start\nduration = 1 s\n"
                                    "[phase turn]\njoints = Neck\ngoal = step\nto = 2 rad\nvelocity = 1 rad/s\n"
                                    "duration = 1 s\n[record]\njoints = Neck\n";
  EXPECT_EQ(experiment({"run", file("far.ini"), "--robot", "virtual", "--record", file("log.csv")}), 2);
  EXPECT_THAT(output,
              HasSubstr("far.ini, line 10: [phase turn] would send Neck to 2 rad; its limits are -1.93 to 1.69"));
  EXPECT_FALSE(std::filesystem::exists(file("log.csv")));
}

class OnServosOfAPty : public Command {
 protected:
  /// Nods the neck to 0.3 rad on a virtual robot with these servo settings, in real time.
  int nod(const std::string& settings, const std::string& robot_ini = "", const std::vector<std::string>& more = {}) {
    std::ofstream{file("nod.ini")} << "[experiment]\nname = nod\ntitle = a nod\n[setup]\npose = start\nduration = 1 s\n"
                                      "[phase nod]\njoints = Neck\ngoal = step\nto = 0.3 rad\nvelocity = 1 rad/s\n"
                                      "duration = 1 s\n[record]\njoints = Neck\n";
    std::ofstream{file("robot.ini")} << robot_ini;
    setenv("DARWINOP_ROBOT_FILE", file("robot.ini").c_str(), 1);
    std::vector<std::string> virtual_robot{std::string{DARWINOP_BIN} + "/darwinop-virtual-robot", "--link",
                                           file("port")};
    if (!settings.empty()) virtual_robot.insert(virtual_robot.end(), {"--servo", settings});
    Program robot{virtual_robot, file("robot.txt")};
    EXPECT_TRUE(robot.says("link:", std::chrono::seconds{10})) << robot.output();
    std::vector<std::string> words{"run", file("nod.ini"), "--robot", file("port"), "--record", file("log.csv")};
    words.insert(words.end(), more.begin(), more.end());
    const int status = experiment(words);
    unsetenv("DARWINOP_ROBOT_FILE");
    return status;
  }
};

TEST_F(OnServosOfAPty, GoalsThatTheServosLimitsClampAreNotDone) {
  EXPECT_EQ(nod("Neck=ccw-limit:2148"), 1);
  EXPECT_THAT(output, HasSubstr(std::string{"Neck"} + experiments::kGoalsClamped));
  EXPECT_THAT(output, HasSubstr("to 0.153 rad\n")) << "the limit";
  EXPECT_THAT(output, HasSubstr(experiments::kRecorded)) << "the recording is kept";
}

TEST_F(OnServosOfAPty, ClampedGoalsMayBeAllowed) {
  EXPECT_EQ(nod("Neck=ccw-limit:2148", "", {"--allow-clamped"}), 0);
  EXPECT_THAT(output, HasSubstr(experiments::kGoalsClamped)) << "they are reported";
}

TEST_F(OnServosOfAPty, ASilentJointIsNotDone) {
  EXPECT_EQ(nod("Neck=missing"), 1);
  EXPECT_THAT(output, HasSubstr(std::string{"Neck"} + experiments::kNotMeasured));
}

TEST_F(OnServosOfAPty, AnAbsentJointMovesNothing) {
  EXPECT_EQ(nod("Neck=missing", "[Robot]\nabsent = Neck\n"), 2);
  EXPECT_THAT(output, HasSubstr(std::string{"nod.ini: Neck"} + experiments::kNamesAbsentJoint));
  EXPECT_FALSE(std::filesystem::exists(file("log.csv")));
}

TEST_F(OnServosOfAPty, AllAsAsked) {
  EXPECT_EQ(nod(""), 0) << output;
}

TEST_F(Command, RobotOverTcpMayBeARealOne) {
  EXPECT_EQ(experiment({"run", "speed", "--robot", "tcp://127.0.0.1:1"}), 3);
  EXPECT_THAT(output, HasSubstr("--yes"));
}

TEST_F(Command, PortThatIsNotAVirtualRobotNeedsYesAndReceivesNothing) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master) + unlockpt(master), 0);
  const std::string port = ptsname(master);
  EXPECT_EQ(experiment({"run", "speed", "--robot", port}), 3);
  EXPECT_THAT(output, HasSubstr("moves    Neck"));
  EXPECT_THAT(output, HasSubstr("--yes"));
  char byte = 0;
  EXPECT_LT(read(master, &byte, 1), 1) << "a byte was sent";
  close(master);
}

TEST_F(Command, DaemonNeedsYes) {
  EXPECT_EQ(experiment({"run", "speed", "--robot", "runtime"}), 3);
  EXPECT_THAT(output, HasSubstr("--yes"));
  EXPECT_EQ(experiment({"run", "speed", "--robot", "runtime", "--yes"}), 2);
  EXPECT_THAT(output, HasSubstr("darwinop runtime --record FILE"));
}

TEST_F(Command, InvalidRobotIsRefusedWithTheChoices) {
  EXPECT_EQ(experiment({"run", "speed", "--robot", "nonsense"}), 2);
  EXPECT_THAT(output, HasSubstr("/dev/ttyUSB0"));
}

}  // namespace
}  // namespace darwinop
