// Joints that a person holds at zero: their readings become offsets in robot.ini.
#include "apps/calibrate/by_hand.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "apps/calibrate/messages.hpp"
#include "connect/lockstep_robot.hpp"
#include "connect/robot_file.hpp"
#include "core/conversions.hpp"

namespace darwinop::calibrate {
namespace {

const std::atomic<bool> kRunning{false};
constexpr double kNeckRad = 0.05;

/// Joints stay where a hand holds them, or tremble.
struct HeldBody final : Body {
  void step(Nanos, const Drives&) noexcept override {
    if (++steps % 100 == 0) now.joint[index(Joint::kHead)].position_rad = steps % 200 == 0 ? 0.02 : -0.02;
  }
  [[nodiscard]] const BodyState& state() const noexcept override { return now; }
  BodyState now;
  int steps = 0;
};

struct ByHand : testing::Test {
  ByHand() : ByHand{cm730::JointOffsets{}} {}
  explicit ByHand(const cm730::JointOffsets& offsets) {
    auto body = std::make_unique<HeldBody>();
    body->now.joint[index(Joint::kNeck)].position_rad = kNeckRad;
    body->now.joint[index(Joint::kFootR)].position_rad = 0.4;  // a horn that is a tooth off
    link = connect::lockstepRobot({}, std::move(body), {.offsets = offsets, .imu = {}});
  }
  std::vector<HeldJoint> read(const std::vector<Joint>& joints, const std::string& typed) {
    std::istringstream answers{typed};
    return readHeldJoints(*link, joints, answers, kRunning, log);
  }
  std::unique_ptr<runtime::RobotLink> link;
  std::ostringstream log;
};

TEST_F(ByHand, TheReadingBecomesTheOffset) {
  const auto held = read({Joint::kNeck}, "\n");
  ASSERT_EQ(held.size(), 1U);
  EXPECT_NEAR(held[0].reading_rad, kNeckRad, kRadPerTick / 2);
  const std::string text = withValues("[Offsets]\nNeck = 0.000\n", "Offsets", iniValues(held, {}, "2026-11-26"));
  EXPECT_NEAR(connect::parseRobotFile(text, "robot.ini").offsets.ticks(Joint::kNeck) * kRadPerTick, kNeckRad,
              kRadPerTick);
  EXPECT_THAT(text, testing::HasSubstr("2026-11-26"));
}

TEST_F(ByHand, AJointThatMovesIsAskedForAgain) {
  EXPECT_TRUE(read({Joint::kHead}, "\n\n\n").empty());
  EXPECT_THAT(log.str(), testing::HasSubstr(messages::kJointMoved));
}

TEST_F(ByHand, AJointCanBeSkippedAndTheRestIsRead) {
  const auto held = read({Joint::kHead, Joint::kNeck}, "s\n\n");
  ASSERT_EQ(held.size(), 1U);
  EXPECT_EQ(held[0].joint, Joint::kNeck);
  EXPECT_TRUE(read({Joint::kNeck}, "q\n").empty());
  EXPECT_TRUE(read({Joint::kNeck}, "").empty()) << "the end of the input is no Enter";
}

TEST_F(ByHand, AHornThatIsAToothOffIsShownAndNotWritten) {
  const auto held = read({Joint::kFootR}, "\n");
  ASSERT_EQ(held.size(), 1U);
  EXPECT_THAT(asText(held, {}), testing::HasSubstr(messages::kHornIsFarOff));
  EXPECT_TRUE(iniValues(held, {}, "2026-11-26").empty());
}

TEST_F(ByHand, AJointUnderTorqueIsRefused) {
  Commands commands;
  commands.start_where_it_is = true;
  for (int cycle = 0; cycle < 200; ++cycle) {
    commands.joint[index(Joint::kNeck)].setGoal(Rad{kNeckRad});
    link->publish(commands);
    ASSERT_TRUE(link->waitForCycle(link->sensors().cycle + 1, kRunning));
  }
  EXPECT_TRUE(read({Joint::kNeck}, "\n\n\n").empty());
  EXPECT_THAT(log.str(), testing::HasSubstr(messages::kUnderTorque));
}

/// With an offset in robot.ini already.
struct ByHandAgain : ByHand {
  static cm730::JointOffsets known() {
    cm730::JointOffsets offsets;
    offsets.set(Joint::kNeck, Rad{0.02});
    return offsets;
  }
  ByHandAgain() : ByHand{known()} {}
};

TEST_F(ByHandAgain, TheOldOffsetIsPartOfTheNewOne) {
  const auto values = iniValues(read({Joint::kNeck}, "\n"), known(), "2026-11-26");
  ASSERT_EQ(values.size(), 1U);
  EXPECT_NEAR(std::stod(values[0].value), kNeckRad, kRadPerTick);
}

}  // namespace
}  // namespace darwinop::calibrate
