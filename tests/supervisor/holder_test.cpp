#include "supervisor/holder.hpp"

#include <gtest/gtest.h>

namespace darwinop::supervisor {
namespace {

TEST(Holder, JointsUnderTorqueHoldAndLimpOnesStayLimp) {
  Sensors seen;
  seen.joint[0].driven = true;
  seen.joint[1].polled.received();
  seen.joint[1].torque_enabled = true;
  seen.joint[2].polled.received();
  const Commands commands = asItIs(seen);
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_FALSE(commands.joint[i].has(JointCommand::kGoal)) << i;
    EXPECT_EQ(commands.joint[i].has(JointCommand::kTorque), i >= 2) << i;
    EXPECT_FALSE(commands.joint[i].torque_on) << i;
  }
  EXPECT_TRUE(commands.start_where_it_is);
  EXPECT_TRUE(commands.unattended) << "must not clear latched faults";
}

TEST(Holder, LightsAreRed) {
  const Commands commands = asItIs(Sensors{});
  EXPECT_TRUE(commands.led.has(LedCommand::kPanel));
  EXPECT_EQ(commands.led.panel, 1);
  EXPECT_TRUE(commands.led.has(LedCommand::kHead));
  EXPECT_EQ(commands.led.head, 0x001F);
  EXPECT_FALSE(commands.led.has(LedCommand::kEye));
}

}  // namespace
}  // namespace darwinop::supervisor
