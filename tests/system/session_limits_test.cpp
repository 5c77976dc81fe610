// A controller with stricter [Limits] and [Safety] than the daemon's, judged by the goals in the servos' registers: a
// real daemon and a real controller on a real pty.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/conversions.hpp"
#include "hil-mocks/pty_host.hpp"
#include "support/temporary_folder.hpp"
#include "system/program.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;

constexpr double kTick = kRadPerTick, kStrictRange = 0.1, kStrictSpeed = 0.3;  // rad, rad, rad/s
constexpr double kPeriod = 0.016;                                              // s, the daemon's default

/// What the test controller asks of one joint, as it reached the servo.
struct Extent {
  double furthest = 0, fastest = 0;  // |goal| in rad, step between two goals in rad
};

class GoalJudge final : public hil::ServoObserver {
 public:
  void written(Joint joint, std::uint8_t, Bytes, const hil::ServoState& before,
               const hil::ServoState& after) noexcept override {
    Extent& seen = extent_[index(joint)];
    if (!after.pulls()) return;
    seen.furthest = std::max(seen.furthest, std::abs(radFromTicks(after.goal).value));
    if (before.pulls()) seen.fastest = std::max(seen.fastest, std::abs(after.goal - before.goal) * kTick);
  }
  void changed(Joint, hil::ServoEvent, const hil::ServoState&, const hil::ServoState&) noexcept override {}

  [[nodiscard]] Extent of(Joint joint) const { return extent_[index(joint)]; }
  void forget() { extent_ = {}; }

 private:
  std::array<Extent, kJoints> extent_;
};

class SessionLimits : public testing::Test {
 protected:
  void SetUp() override {
    setenv("DARWINOP_RUNTIME_NAME", (folder_ / "runtime").c_str(), 1);
    setenv("DARWINOP_ROBOT", "runtime", 1);
    std::filesystem::copy_file(DARWINOP_TEST_CONTROLLER, folder_ / "controller");
    host_.withRobot([this](hil::VirtualRobot& robot) { robot.board().observe(&judge_); });
  }
  void TearDown() override {
    host_.withRobot([](hil::VirtualRobot& robot) { robot.board().observe(nullptr); });
    unsetenv("DARWINOP_ROBOT");
  }
  bool isLimp() {
    return host_.withRobot([](hil::VirtualRobot& robot) {
      for (const JointRow& joint : kJointTable)
        if (robot.board().servo(static_cast<Joint>(joint.id - 1)).state().pulls()) return false;
      return true;
    });
  }
  /// One session with this config.ini (empty: none), to the robot's rest: neck and elbow.
  std::array<Extent, 2> drive(const std::string& config) {
    std::filesystem::remove(folder_ / "config.ini");
    if (!config.empty()) std::ofstream{folder_ / "config.ini"} << config;
    host_.withRobot([this](hil::VirtualRobot&) { judge_.forget(); });
    Program controller{{folder_ / "controller", "200"}, folder_ / "controller.txt"};
    EXPECT_EQ(controller.wait(seconds{60}), 0) << controller.output();
    EXPECT_TRUE(controller.says("done", seconds{1})) << controller.output();
    for (int i = 0; i < 3000 && !isLimp(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds{10});
    EXPECT_TRUE(isLimp());
    return host_.withRobot([this](hil::VirtualRobot&) {
      return std::array{judge_.of(Joint::kNeck), judge_.of(Joint::kArmLowerR)};
    });
  }

  TemporaryFolder folder_;
  GoalJudge judge_;
  hil::VirtualRobot robot_;
  hil::PtyHost host_{robot_};
};

TEST_F(SessionLimits, UnderTheDaemonTheServosGetTheControllersStricterGoalsInItsSessionOnly) {
  Program daemon{{DARWINOP_BIN "/darwinop-runtime", "--robot", host_.path()}, folder_ / "daemon.txt"};
  ASSERT_TRUE(daemon.says("ready:", seconds{20})) << daemon.output();
  const auto expect_lax = [](const std::array<Extent, 2>& seen) {
    EXPECT_GT(seen[0].furthest, 0.4);
    EXPECT_GT(seen[1].fastest, 1.5 * kStrictSpeed * kPeriod);
  };
  expect_lax(drive(""));
  const auto [neck, elbow] = drive("[Limits]\nNeck = -0.1, 0.1\n[Safety]\nmax_joint_speed = 0.3\ngentle_speed = 0.3\n");
  EXPECT_GT(neck.furthest, 0.09) << "it was asked to go beyond";
  EXPECT_LE(neck.furthest, kStrictRange + kTick);
  EXPECT_GT(elbow.fastest, 0.5 * kStrictSpeed * kPeriod);
  EXPECT_LE(elbow.fastest, kStrictSpeed * kPeriod + kTick);
  EXPECT_LE(neck.fastest, kStrictSpeed * kPeriod + kTick);
  expect_lax(drive(""));

  // The daemon's own limits cannot be widened.
  daemon.kill(SIGTERM);
  ASSERT_EQ(daemon.wait(seconds{30}), 0) << daemon.output();
  std::ofstream{folder_ / "daemon.ini"} << "[Limits]\nNeck = -0.1, 0.1\n";
  Program strict{{DARWINOP_BIN "/darwinop-runtime", "--robot", host_.path(), "--config", folder_ / "daemon.ini"},
                 folder_ / "strict.txt"};
  ASSERT_TRUE(strict.says("ready:", seconds{20})) << strict.output();
  EXPECT_LE(drive("[Limits]\nNeck = -1.0, 1.0\n")[0].furthest, kStrictRange + kTick);
  strict.kill(SIGTERM);
  EXPECT_EQ(strict.wait(seconds{30}), 0) << strict.output();
}

}  // namespace
}  // namespace darwinop
