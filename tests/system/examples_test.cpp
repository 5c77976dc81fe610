// The examples that use legs, on the twin: one that plays alone, and one that falls and gets up.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/faults.hpp"
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
  EXPECT_THAT(said, Not(HasSubstr("I fell")));
  const std::string before = "It lies ";
  const auto at = said.find(before);
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_GT(std::strtol(said.c_str() + at + before.size(), nullptr, 10), 60) << "cm, and it was at 13";
}

TEST_F(Soccer, AWordThatItDoesNotKnowMovesNothing) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{DARWINOP_SOCCER, "--help"},
                                                {DARWINOP_SOCCER, "--seconds"},
                                                {DARWINOP_SOCCER, "--seconds", "abc"},
                                                {DARWINOP_WALK, "--seconds", "1s"},
                                                {DARWINOP_WALK, "--help"},
                                                {DARWINOP_WALK, "--seconds", "1", "--x"}}) {
    Program running{words, file("run.txt")};
    EXPECT_EQ(running.wait(std::chrono::seconds{60}), 2);
    EXPECT_THAT(running.output(), HasSubstr("usage: ")) << words.back();
  }
}

TEST_F(Soccer, WithoutABallItLooksForOneAndKicksNothing) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "none"};
  const std::string said = play("8");
  EXPECT_THAT(said, Not(HasSubstr("I kick")));
  EXPECT_THAT(said, Not(HasSubstr("I fell")));
}

class Walker : public Rig {
 protected:
  /// 05_walk with a trunk that leans by so much that it falls, more than once, and recorded.
  std::string walk(const std::string& lean) {
    const runtime::Environment ball{"DARWINOP_TWIN_BALL", "none"};
    const std::string copy = file("05_walk");
    std::filesystem::copy_file(DARWINOP_WALK, copy);
    std::ofstream{file("config.ini")} << "[Robot Config]\ntime_step = 16\n[Walking Config]\nhip_pitch_offset = " << lean
                                      << '\n';
    Program running{{program("darwinop-run"), "--robot", "twin", "--record", file("log.csv"), copy, "--seconds", "15"},
                    file("run.txt")};
    EXPECT_EQ(running.wait(std::chrono::seconds{240}), 1) << running.output();
    return running.output();
  }
  /// Towards its front when it has fallen for the first time, m/s2: negative on its face.
  [[nodiscard]] double accelerationAfterTheFall() const {
    const Recording log{file("log.csv")};
    for (std::size_t row = 0; row < log.rows(); ++row)
      if (log.at(row, "safety.fault") == static_cast<double>(Fault::kFell))
        return log.at(row, "accelerometer.y [m/s2]");
    return std::nan("");
  }
};

TEST_F(Walker, ThatLeansTooFarForwardsFallsOnItsFaceAndGetsUp) {
  const std::string said = walk("38");
  EXPECT_LT(accelerationAfterTheFall(), -5);
  EXPECT_THAT(said, HasSubstr("fault 30 fell is over")) << "the safety layer's word for it";
}

TEST_F(Walker, ThatLeansBackFallsOnItsBackAndGetsUp) {
  const std::string said = walk("5");
  EXPECT_GT(accelerationAfterTheFall(), 5);
  EXPECT_THAT(said, HasSubstr("fault 30 fell is over")) << "the safety layer's word for it";
}

}  // namespace
}  // namespace darwinop
