// The judge of the wire: a second SyncWrite needs a servo that works at its torque limit.
#include "campaign/wire_judge.hpp"

#include <gtest/gtest.h>

#include <array>

#include "hil-mocks/virtual_robot.hpp"

namespace darwinop {
namespace {

struct TwoSyncWrites : ::testing::Test {
  hil::VirtualRobot robot;
  WireJudge judge{robot, Nanos{16'000'000}, 12};

  /// A SyncWrite of one value to the torque limit of the first servo.
  void writeLimit(std::uint16_t limit) {
    const std::array<std::uint8_t, 5> params{servo::kTorqueLimit, 2, 1, lowByte(limit), highByte(limit)};
    judge.request(Frame{kBroadcastId, static_cast<std::uint8_t>(Instruction::kSyncWrite), params}, Nanos{0});
  }
  /// A cycle with these limits, after which the first servo reports this load.
  void cycle(std::initializer_list<std::uint16_t> limits, double load) {
    judge.beginCycle();
    for (const std::uint16_t limit : limits) writeLimit(limit);
    Sensors seen;
    seen.joint[0].motion.age = 0;
    seen.joint[0].load = load;
    judge.endCycle(seen);
  }
};

TEST_F(TwoSyncWrites, AreAcceptedWhileAServoWorksAtItsLimit) {
  cycle({512}, 0);
  cycle({512}, 0.45);
  cycle({512, 512}, 0);
  EXPECT_EQ(judge.failure(), "");
  EXPECT_EQ(judge.tolerated().of(Leniency::kSecondSyncWrite), 1);
}

TEST_F(TwoSyncWrites, AreBlamedOtherwise) {
  cycle({512}, 0);
  cycle({512}, 0.35);  // less than 80 % of the limit
  EXPECT_EQ(judge.failure(), "");
  cycle({512, 512}, 0);
  EXPECT_NE(judge.failure(), "");
}

TEST_F(TwoSyncWrites, AreMeasuredByTheSmallerOfTheLastTwoLimits) {
  cycle({100}, 0);
  cycle({1023}, 0.1);  // the second write may have been lost
  cycle({1023, 1023}, 0);
  EXPECT_EQ(judge.failure(), "");
}

TEST_F(TwoSyncWrites, AreNeverThree) {
  cycle({100}, 0);
  cycle({100}, 1);
  cycle({100, 100, 100}, 0);
  EXPECT_NE(judge.failure(), "");
}

}  // namespace
}  // namespace darwinop
