// A virtual MX-64: the scale of its torque registers, and registers that an MX-28 lacks.
#include <gtest/gtest.h>

#include "bench.hpp"
#include "hil-mocks/robot_options.hpp"

namespace darwinop::hil {
namespace {

BoardOptions neck(const char* setting) {
  BoardOptions options = Bench::powered();
  setServo(options, setting);
  return options;
}

/// Load register of the neck, without direction, while the motor pushes as much as its torque limit permits.
int loadAtLimit(Bench& bench, const std::string& write_of_the_limit) {
  bench.send(withChecksum(write_of_the_limit));
  bench.send(withChecksum("FF FF 13 05 03 1C FE 00"));  // highest P gain
  bench.send(withChecksum("FF FF 13 05 03 1E 00 0C"));  // far away
  bench.board.advance(bench.board.now() + 4ms);
  EXPECT_NE(bench.send(withChecksum("FF FF 13 04 02 28 02")), "");
  return bench.board.servo(Joint::kNeck).table().word(40) & 1023;
}

TEST(StrongerServo, NeedsASmallerPartOfItsTorqueForTheSamePush) {
  Bench mx28, mx64{neck("Neck=model:310")};
  EXPECT_EQ(loadAtLimit(mx28, "FF FF 13 05 03 22 FF 03"), 1023);
  const double before = mx28.body.state().joint[index(Joint::kNeck)].velocity_rad_s;
  EXPECT_NEAR(loadAtLimit(mx64, "FF FF 13 05 03 22 AA 01"), 426, 1) << "2.5 of its 6 N m";
  EXPECT_NEAR(mx64.body.state().joint[index(Joint::kNeck)].velocity_rad_s, before, 0.01 * before);
}

TEST(StrongerServo, HasTheRegistersOfItsModes) {
  Bench mx28, mx64{neck("Neck=model:310")};
  const std::string torque_control = withChecksum("FF FF 13 04 03 46 01"), ok = withChecksum("FF FF 13 02 00");
  EXPECT_EQ(mx28.send(torque_control), withChecksum("FF FF 13 02 08")) << "an MX-28 has none";
  EXPECT_EQ(mx64.send(torque_control), ok);
  EXPECT_EQ(mx64.board.servo(Joint::kNeck).table().byte(servo::kTorqueControl), 1);
  mx64.send(withChecksum("FF FF C8 04 03 18 00"));
  mx64.send(withChecksum("FF FF C8 04 03 18 01"));
  EXPECT_EQ(mx64.board.servo(Joint::kNeck).table().byte(servo::kTorqueControl), 0) << "off after power-up";
}

}  // namespace
}  // namespace darwinop::hil
