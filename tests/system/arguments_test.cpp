// Wrong arguments of all programs: exit codes and messages.
#include <gmock/gmock.h>

#include <fstream>
#include <string>
#include <utility>

#include "system/command_line.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;

TEST_F(CommandLine, EachCommandOfExperimentHasItsOwnExample) {
  for (const std::string command : {"list", "show", "run", "plot"})
    EXPECT_THAT(call("experiment " + command + " --help").said, HasSubstr("\n  darwinop " + ("experiment " + command)));
}

TEST_F(CommandLine, WrongArgumentsEndEveryProgramWithStatus2) {
  for (const char* name : {"calibrate", "demo", "doctor", "experiment", "gap", "monitor", "motion", "remote", "run",
                           "runtime", "supervisor", "twin", "virtual-camera", "virtual-robot", "window"}) {
    const Outcome refused = call(std::string{name} + " --no-such-option");
    EXPECT_EQ(refused.status, 2) << name;
    EXPECT_THAT(refused.said, testing::StartsWith(std::string{"darwinop "} + name + ": "));
    EXPECT_EQ(call(std::string{name} + " --help").status, 0) << name;
    EXPECT_EQ(call(std::string{name} + " --version").status, 0) << name;
  }
}

TEST_F(CommandLine, ArgumentsThatCannotBeUsedEndEveryProgramWithTheSameCode) {
  std::ofstream{file("faults.txt")} << "0 nonesuch\n";
  for (const char* arguments :
       {"virtual-robot --body twn", "virtual-robot --servo Nekc=wheel", "virtual-robot --board cm730",
        "virtual-robot --faults faults.txt", "virtual-camera --pictures nosuch", "monitor --listen 0.0.0.0",
        "remote --robot nope", "remote --config nope.ini", "remote --listen 0.0.0.0", "supervisor",
        "runtime --config nope.ini", "runtime --realtime reqired"}) {
    const Outcome refused = call(arguments);
    const std::string program = std::string{arguments}.substr(0, std::string{arguments}.find(' '));
    EXPECT_EQ(refused.status, 2) << arguments;
    EXPECT_THAT(refused.said, HasSubstr("darwinop " + program + ": ")) << arguments;
  }
}

TEST_F(CommandLine, AMistypedCommandIsNamedWithThoseThatThereAre) {
  const std::pair<const char*, const char*> mistyped[] = {
      {"experiment rnu speed", "no command 'rnu'; there are list, show, run, plot; see darwinop experiment --help"},
      {"twin record", "no command 'record'; there are view, picture, models, effects"},
      {"demo run", "no command 'run'; there are walk"},
      {"gap --json lcoate x", "no command 'lcoate'; there are check, locate, run"},
      {"gap benchmark rnu x", "no command 'rnu'; there are run, make"},
      {"motion", "A subcommand is required"}};
  for (const auto& [arguments, text] : mistyped) {
    const Outcome refused = call(arguments);
    EXPECT_EQ(refused.status, 2) << arguments;
    EXPECT_THAT(refused.said, HasSubstr(text));
  }
}

TEST_F(CommandLine, ExamplesRefuseArgumentsThatTheyDoNotHave) {
  for (const std::string name :
       {"01_hello_head", "02_symmetry", "03_leds_and_buttons", "04_visual_tracking", "05_walk", "06_soccer", "07_talk"})
    for (const char* arguments : {"--secnds 1", "--seconds abc", "--seconds", "--seconds 1 --loud"}) {
      const Outcome refused = shell("DARWINOP_ROBOT=virtual timeout 5 " DARWINOP_EXAMPLES "/" + name + "/" + name +
                                    " " + arguments + " </dev/null");
      EXPECT_EQ(refused.status, 2) << name << " " << arguments;
      EXPECT_THAT(refused.said, testing::StartsWith("usage: " + name + " [--seconds N]"));
    }
}

TEST_F(CommandLine, SoccerThatCannotBePlayedEndsWithAFailure) {
  startVirtualRobot("", {"--board", "none"});
  std::ofstream{file("robot.ini")} << "[Robot]\nboard = none\n";
  const Outcome ended = shell("DARWINOP_ROBOT=" + port() + " DARWINOP_ROBOT_FILE=" + file("robot.ini") +
                              " timeout 30 " DARWINOP_EXAMPLES "/06_soccer/06_soccer --seconds 1 </dev/null");
  EXPECT_EQ(ended.status, 1) << ended.said;
}

}  // namespace
}  // namespace darwinop
