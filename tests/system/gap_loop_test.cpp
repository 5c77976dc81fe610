// The loop closed: a robot is measured over its serial line, what its model misses is named from the recordings and put
// into the model, and then robot and model move alike. Every file on the way is written by a command.
#include <gmock/gmock.h>

#include <cmath>

#include "support/text_of.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

constexpr int kNamed = 10;  // exit code of darwinop gap run

class GapLoop : public Rig {
 protected:
  /// From here on the robot is the twin with this model, in real time behind a serial line.
  void robotIs(const std::string& model) {
    if (virtual_robot_) countersOfVirtualRobot();  // ends it: the port is free again
    virtual_robot_ = std::make_unique<Program>(
        std::vector<std::string>{program("darwinop-virtual-robot"), "--body", "twin:" + model, "--link", port()},
        file("virtual-robot.txt"));
    ASSERT_TRUE(virtual_robot_->says("link:", seconds{20})) << virtual_robot_->output();
  }

  /// To its end; the status.
  int command(const std::vector<std::string>& words, seconds at_most) {
    std::vector<std::string> all = words;
    all.front() = program(all.front());
    Program running{all, file("command.txt")};
    const auto status = running.wait(at_most);
    said_ = running.output();
    return status.value_or(-1);
  }

  std::string measured(const std::string& experiment, const std::string& name) {
    return recorded(experiment, port(), name);
  }
  std::string recorded(const std::string& experiment, const std::string& robot, const std::string& name) {
    EXPECT_EQ(
        command({"darwinop-experiment", "run", experiment, "--robot", robot, "--record", file(name)}, seconds{90}), 0)
        << said_;
    return file(name);
  }

  void closeTheLoop(double floor_rad);

  std::string said_;  // by the last command
};

/// Rms difference of the shoulder's angle while both controllers ask for the same, rad. The robots' clocks differ by
/// whole rows: the goals say by how many.
double difference(const std::string& one, const std::string& other) {
  const Recording a{one}, b{other};
  const auto goal = [](const Recording& log, std::size_t row) { return log.at(row, "ShoulderR.commanded [rad]"); };
  const auto angle = [](const Recording& log, std::size_t row) { return log.at(row, "ShoulderR.position [rad]"); };
  double best = 1e9, found = 1e9;
  for (std::size_t shift = 0; shift <= 120; ++shift) {
    double goals = 0, angles = 0;
    int count = 0;
    for (std::size_t row = 60; row < std::min(a.rows(), b.rows()) - 120; ++row) {
      const std::size_t there = row + shift - 60;
      const double goal_off = goal(a, row) - goal(b, there), off = angle(a, row) - angle(b, there);
      if (std::isnan(goal_off) || std::isnan(off)) continue;
      goals += goal_off * goal_off, angles += off * off, ++count;
    }
    if (count > 300 && goals / count < best) best = goals / count, found = std::sqrt(angles / count);
  }
  return found;
}

void GapLoop::closeTheLoop(double floor_rad) {
  const std::string original = DARWINOP_USUAL_MODEL, hidden = file("hidden.ini"), repaired = file("repaired.ini");
  std::ofstream{hidden} << textOf(original) << "\n[effect accel_limit]\naccel = 30 rad/s2\n";

  robotIs(hidden);
  const std::string steps = measured("steps", "steps.csv"), slow = measured("slow_triangle", "slow.csv"),
                    chirp = measured("chirp", "chirp.csv");

  ASSERT_EQ(command({"darwinop-gap", "case", steps, slow, "--keep", chirp, "--joint", "ShoulderR", "--model", original,
                     "--out", file("case")},
                    seconds{20}),
            0)
      << said_;
  ASSERT_EQ(command({"darwinop-gap", "run", file("case"), "--report", file("report"), "--no-open"}, seconds{280}),
            kNamed)
      << said_;
  EXPECT_THAT(said_, HasSubstr("accel_limit"));
  ASSERT_EQ(
      command({"darwinop-gap", "add", "--model", original, file("case"), file("report/report.json"), "--out", repaired},
              seconds{20}),
      0)
      << said_;
  EXPECT_THAT(textOf(repaired), HasSubstr("[effect accel_limit]"));
  EXPECT_THAT(textOf(repaired), testing::StartsWith(textOf(original).substr(0, 500))) << "the rest is as it was";

  const double before_rad = difference(steps, recorded("steps", "twin:" + original, "before.csv"));
  robotIs(repaired);
  const double after_rad = difference(steps, measured("steps", "after.csv"));
  EXPECT_GT(before_rad, 0.1) << "what was hidden shows";
  EXPECT_LT(after_rad, floor_rad);
}

TEST_F(GapLoop, WhatIsHiddenInARobotIsNamedAndTheModelThenMovesLikeIt) {
  closeTheLoop(0.025);  // a reading may come 5 ms earlier or later than in the other run, at up to 5 rad/s
}

}  // namespace
}  // namespace darwinop
