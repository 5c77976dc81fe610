// Counts to SI and back: exact, inverse of each other, and where they differ from the wrapper of 2013.
#include "core/conversions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace darwinop {
namespace {

TEST(Position, EveryTickComesBack) {
  for (int tick = 0; tick <= kTickMax; ++tick) EXPECT_EQ(ticksFromRad(radFromTicks(tick)), tick);
}

TEST(Position, MiddleIsZeroAndAQuarterTurnIs1024Ticks) {
  EXPECT_EQ(radFromTicks(2048).value, 0.0);
  EXPECT_DOUBLE_EQ(radFromTicks(3072).value, kPi / 2);
  EXPECT_DOUBLE_EQ(radFromTicks(0).value, -kPi);
}

TEST(Position, StaysWithinTheEncoderForAnyFiniteAngle) {
  EXPECT_EQ(ticksFromRad(Rad{kPi}), kTickMax);
  EXPECT_EQ(ticksFromRad(Rad{1e9}), kTickMax);
  EXPECT_EQ(ticksFromRad(Rad{-1e300}), 0);
}

RC_GTEST_PROP(PositionProperty, IsOffByHalfATickAtMost, ()) {
  const double angle = *rc::gen::inRange(-3141, 3140) / 1000.0;
  RC_ASSERT(std::abs(radFromTicks(ticksFromRad(Rad{angle})).value - angle) <= kRadPerTick / 2 + 1e-12);
}

// What the on-robot wrapper of 2013 did instead, for controllers that were tuned on it. Its two factors are
// not each other's inverse: 11.378 ticks a degree on the way out (truncated towards zero), 0.088 degrees a tick
// on the way back (0.125 % too large). 1 rad went out as 2699 where 2700 is nearest; 0.5 rad read back as
// 0.49916. This runtime uses the exact law above; a controller can see a difference of one tick going out
// and of at most 4 mrad coming back at the ends of the range.
constexpr int ticksFromRadAsIn2013(Rad angle) {
  return static_cast<int>(angle.value * 180.0 / kPi * 11.378) + kTickCentre;
}
constexpr Rad radFromTicksAsIn2013(int ticks) {
  return Rad{(ticks - kTickCentre) * 0.088 * kRadPerDegree};
}

TEST(Position, OneRadianIs2700TicksHereAnd2699In2013) {
  EXPECT_EQ(ticksFromRad(Rad{1.0}), 2700);
  EXPECT_EQ(ticksFromRadAsIn2013(Rad{1.0}), 2699);
}

TEST(Position, HalfARadianReadBackWasShortIn2013) {
  EXPECT_EQ(ticksFromRadAsIn2013(Rad{0.5}), 2373);
  EXPECT_NEAR(radFromTicksAsIn2013(2373).value, 0.49916, 5e-6);
  EXPECT_NEAR(radFromTicksAsIn2013(ticksFromRadAsIn2013(Rad{3.0})).value, 3.00266, 5e-6);
}

RC_GTEST_PROP(PositionProperty, DiffersFrom2013ByOneTickOutAnd4MilliradiansBack, ()) {
  const double angle = *rc::gen::inRange(-3141, 3141) / 1000.0;
  RC_ASSERT(std::abs(ticksFromRad(Rad{angle}) - ticksFromRadAsIn2013(Rad{angle})) <= 1);
  const int tick = *rc::gen::inRange(0, kTickMax + 1);
  RC_ASSERT(std::abs(radFromTicks(tick).value - radFromTicksAsIn2013(tick).value) < 4e-3);
}

TEST(Speed, FullScaleIs12RadPerSec) {
  EXPECT_NEAR(velocityFromRegister(1023).value, 12.213, 5e-4);
  EXPECT_EQ(registerFromVelocity(RadPerSec{1e6}), 1023);
}

TEST(Speed, DirectionIsBitTenAndZeroHasNone) {
  EXPECT_EQ(velocityFromRegister(1024 + 100).value, -velocityFromRegister(100).value);
  EXPECT_EQ(velocityFromRegister(1024).value, 0.0);  // 2013: -1 count
  EXPECT_EQ(registerFromVelocity(RadPerSec{-1e-9}), 0);
}

TEST(Speed, EveryRegisterValueComesBack) {
  for (int raw = 0; raw < 2048; ++raw) {
    if (raw == 1024) continue;  // zero written another way
    const auto value = static_cast<std::uint16_t>(raw);
    EXPECT_EQ(registerFromVelocity(velocityFromRegister(value)), value);
  }
}

TEST(Speed, ALimitIsNeverZeroBecauseZeroMeansUnlimited) {
  EXPECT_EQ(registerFromSpeedLimit(RadPerSec{0}), 1);
  EXPECT_EQ(registerFromSpeedLimit(RadPerSec{1e-9}), 1);
  EXPECT_EQ(registerFromSpeedLimit(RadPerSec{1000}), 1023);
}

TEST(Speed, ALimitsSignIsIgnored) {
  EXPECT_EQ(registerFromSpeedLimit(RadPerSec{-3}), registerFromSpeedLimit(RadPerSec{3}));
}

TEST(Load, EveryRegisterValueComesBack) {
  for (int raw = 0; raw < 2048; ++raw) {
    if (raw == 1024) continue;
    const auto value = static_cast<std::uint16_t>(raw);
    EXPECT_EQ(registerFromLoad(loadFromRegister(value)), value);
  }
  EXPECT_EQ(loadFromRegister(1023), 1.0);
  EXPECT_EQ(loadFromRegister(2047), -1.0);
}

TEST(Torque, StallTorqueIsFullScale) {
  EXPECT_EQ(registerFromTorque(NewtonMeter{2.5}), 1023);
  EXPECT_EQ(registerFromTorque(NewtonMeter{9}), 1023);
  EXPECT_EQ(registerFromTorque(NewtonMeter{-1}), 0);
  EXPECT_DOUBLE_EQ(torqueFromRegister(1023).value, 2.5);
}

TEST(Torque, EveryRegisterValueComesBack) {
  for (int raw = 0; raw <= kTorqueMax; ++raw) {
    const auto value = static_cast<std::uint16_t>(raw);
    EXPECT_EQ(registerFromTorque(torqueFromRegister(value)), value);
  }
}

TEST(Gain, FactoryGainOf32IsKp4) {
  EXPECT_EQ(registerFromPGain(4.0), 32);
  EXPECT_EQ(registerFromPGain(100), 254);  // 2013 wrapped round
  EXPECT_EQ(registerFromPGain(-1), 0);
}

TEST(Voltage, IsInTenths) {
  EXPECT_DOUBLE_EQ(voltFromRegister(118).value, 11.8);
}

}  // namespace
}  // namespace darwinop
