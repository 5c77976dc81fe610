// Everything at once: eyes, legs and pages of a robot that plays alone.
#include <gmock/gmock.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "runtime/environment.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;
using testing::Not;

class Soccer : public Rig {
 protected:
  /// The example, for `time` of the robot's clock.
  std::string play(const std::string& time) {
    Program running{{program("darwinop-run"), "--robot", "twin", DARWINOP_SOCCER, "--seconds", time}, file("run.txt")};
    EXPECT_EQ(running.wait(std::chrono::seconds{240}), 0) << running.output();
    return running.output();
  }
};

TEST_F(Soccer, AtABallThatRestsItIsKickedFarAway) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "rests"};
  const std::string said = play("26");
  EXPECT_THAT(said, HasSubstr("I kick the ball"));
  EXPECT_THAT(said, Not(HasSubstr("I fell")));
  const std::string before = "It lies ";
  const auto at = said.find(before);
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_GT(std::strtol(said.c_str() + at + before.size(), nullptr, 10), 60) << "cm, and it was at 13";
}

TEST_F(Soccer, AWordThatItDoesNotKnowMovesNothing) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{DARWINOP_SOCCER, "--help"},
                                                {DARWINOP_SOCCER, "--seconds"},
                                                {DARWINOP_WALK, "--help"},
                                                {DARWINOP_WALK, "--seconds", "1", "--x"}}) {
    Program running{words, file("run.txt")};
    EXPECT_EQ(running.wait(std::chrono::seconds{60}), 1);
    EXPECT_THAT(running.output(), HasSubstr("usage: ")) << words.back();
  }
}

TEST_F(Soccer, WithoutABallItLooksForOneAndKicksNothing) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "none"};
  const std::string said = play("8");
  EXPECT_THAT(said, Not(HasSubstr("I kick")));
  EXPECT_THAT(said, Not(HasSubstr("I fell")));
}

}  // namespace
}  // namespace darwinop
