// Rows that do not count after a limp joint has fallen on its stop.
#include "gap/localize/body/stop_contact.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace darwinop::gap {
namespace {

constexpr double kRow = 0.016;  // s
constexpr double kStop = 0.7;   // rad

/// An elbow behind a shoulder; the shoulder is limp for 30 rows, falls on its stop, and is then held where it lies.
class FallOnAStop : public testing::Test {
 protected:
  FallOnAStop() {
    limb_[0].joint = Joint::kShoulderR, limb_[1].joint = Joint::kArmLowerR;
    for (Link& link : limb_) link.low_rad = -kStop, link.high_rad = kStop;
    given_.logs.resize(1);
    given_.joints.logs.resize(kJoints);
    for (int row = 0; row < 200; ++row) {
      given_.logs[0].time_s.push_back(kRow * row);
      const bool is_limp = row >= 20 && row < 50, lies = row >= 40;
      append(shoulder(), row, {.position = lies ? end_ : 0, .goal = row >= 50 ? end_ : 0, .is_limp = is_limp});
      append(elbow(), row, {});
    }
  }

  struct State {
    double position = 0, goal = 0;
    bool is_limp = false;
  };
  static void append(Trajectory& to, int row, const State& state) {
    to.time_s.push_back(kRow * row);
    to.position_rad.push_back(state.position), to.goal_rad.push_back(state.goal);
    to.torque_on.push_back(state.is_limp ? 0 : 1);
  }
  Trajectory& shoulder() { return given_.joints.logs[static_cast<std::size_t>(Joint::kShoulderR)]; }
  Trajectory& elbow() { return given_.joints.logs[static_cast<std::size_t>(Joint::kArmLowerR)]; }
  [[nodiscard]] std::vector<std::vector<bool>> lost() const { return lostAtStops(given_, 0, limb_); }

  double end_ = kStop - 0.01;
  BodyCase given_;
  Limb limb_{2};
};

TEST_F(FallOnAStop, TakesTheWholeLimbUntilItsServoHasCaughtIt) {
  EXPECT_FALSE(lost()[1][39]);
  EXPECT_TRUE(lost()[1][40]);
  EXPECT_TRUE(lost()[1][65]) << "0.25 s after power";
  EXPECT_FALSE(lost()[1][75]) << "0.4 s after power";
}

TEST_F(FallOnAStop, TakesTheJointItselfUntilItHasBeenMovedAway) {
  EXPECT_FALSE(lost()[0][39]);
  EXPECT_TRUE(lost()[0][75]);
  EXPECT_TRUE(lost()[0][199]) << "friction still holds it where it fell";
  for (std::size_t row = 120; row < 200; ++row) shoulder().position_rad[row] = shoulder().goal_rad[row] = 0.3;
  EXPECT_TRUE(lost()[0][119]);
  EXPECT_FALSE(lost()[0][120]);
}

TEST_F(FallOnAStop, LeavesAJointThatIsDrivenToItsStop) {
  for (std::uint8_t& on : shoulder().torque_on) on = 1;
  for (const std::vector<bool>& joint : lost())
    for (const bool row : joint) EXPECT_FALSE(row);
}

TEST_F(FallOnAStop, IsNotOverAtARowWithoutAPosition) {
  shoulder().position_rad[100] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(lost()[0][100]);
  EXPECT_TRUE(lost()[0][101]);
}

}  // namespace
}  // namespace darwinop::gap
