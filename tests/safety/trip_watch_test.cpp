// In the first 0.3 s under torque an overload bit may be a memory: it is a suspicion, not a fault.
#include "safety/trip_watch.hpp"

#include <gtest/gtest.h>

#include "core/packet.hpp"

namespace darwinop::safety {
namespace {

using Verdict = TripWatch::Verdict;
using std::chrono::milliseconds;

constexpr Nanos kInGrace{milliseconds{100}};
static_assert(kInGrace < TripWatch::kGrace);

JointSensors answer(std::uint8_t error_bits) {
  JointSensors seen;
  seen.motion.received();
  seen.error_bits = error_bits;
  return seen;
}
JointSensors look(std::uint8_t error_bits, double torque_limit, bool torque_enabled) {
  JointSensors seen = answer(error_bits);
  seen.polled.received();
  seen.torque_limit = NewtonMeter{torque_limit};
  seen.torque_enabled = torque_enabled;
  return seen;
}

TEST(TripWatchInGrace, AnOverloadBitKeepsTheServoOutOfWritesAndIsNotAFaultHoweverOftenItComes) {
  TripWatch watch;
  for (Nanos driven{0}; driven < TripWatch::kGrace; driven += milliseconds{16})
    ASSERT_EQ(watch.update(answer(error_bit::kOverload), driven), Verdict::kSuspected);
}

TEST(TripWatchInGrace, AnAnswerWithoutTheBitEndsTheSuspicion) {
  TripWatch watch;
  EXPECT_EQ(watch.update(answer(error_bit::kOverload), kInGrace), Verdict::kSuspected);
  EXPECT_EQ(watch.update(answer(0), kInGrace), Verdict::kFine);
}

TEST(TripWatchInGrace, ALostAnswerDoesNotEndTheSuspicion) {
  TripWatch watch;
  EXPECT_EQ(watch.update(answer(error_bit::kOverload), kInGrace), Verdict::kSuspected);
  EXPECT_EQ(watch.update(JointSensors{}, kInGrace), Verdict::kSuspected);
}

TEST(TripWatchInGrace, ATorqueLimitOfZeroKeepsTheServoOutOfWrites) {
  TripWatch watch;
  EXPECT_EQ(watch.update(look(0, 0, false), kInGrace), Verdict::kSuspected);
  EXPECT_EQ(watch.update(look(0, 2.5, true), kInGrace), Verdict::kFine);
}

TEST(TripWatchInGrace, ABitThatOutlivesTheGraceIsAShutdownAtTheSecondAnswer) {
  TripWatch watch;
  EXPECT_EQ(watch.update(answer(error_bit::kOverload), kInGrace), Verdict::kSuspected);
  EXPECT_EQ(watch.update(answer(error_bit::kOverload), TripWatch::kGrace), Verdict::kSuspected);
  EXPECT_EQ(watch.update(answer(error_bit::kOverload), TripWatch::kGrace), Verdict::kOverload);
}

TEST(TripWatch, ATorqueLimitOfZeroIsAShutdownAtTheSecondLookAlsoWhereTorqueStaysEnabled) {
  TripWatch watch;
  EXPECT_EQ(watch.update(look(0, 2.5, true), TripWatch::kGrace), Verdict::kFine);
  EXPECT_EQ(watch.update(look(0, 0, true), TripWatch::kGrace), Verdict::kSuspected);
  EXPECT_EQ(watch.update(look(0, 0, true), TripWatch::kGrace), Verdict::kOverload);
}

TEST(TripWatchInGrace, AServoThatIsNotDrivenIsNotSuspected) {
  TripWatch watch;
  EXPECT_EQ(watch.update(answer(error_bit::kOverload), kInGrace), Verdict::kSuspected);
  EXPECT_EQ(watch.update(answer(error_bit::kOverload), std::nullopt), Verdict::kFine);
}

}  // namespace
}  // namespace darwinop::safety
