// Recordings on the floor that contradict what all of them together suggest.
#include "gap/identify/body/floor_agreement.hpp"

#include <gtest/gtest.h>

namespace darwinop::gap {
namespace {

TEST(FloorAgreement, WhatAnEffectLeavesUnexplainedDoesNotContradictIt) {
  EXPECT_FALSE(refute({{.gain = 400, .change = 1500}, {.gain = -40, .change = 990}}))
      << "the second log is a walk of another engine: it gains little, and loses little";
}

TEST(FloorAgreement, OneLogThatTheEffectMakesAsUnlikelyAsIfItWereNotThereContradictsIt) {
  EXPECT_TRUE(refute({{.gain = 4000, .change = 12000}, {.gain = -160, .change = 130}}));
}

TEST(FloorAgreement, AllLogsTogetherHaveToGain) {
  EXPECT_TRUE(refute({{.gain = 30, .change = 600}, {.gain = -40, .change = 990}}));
  EXPECT_FALSE(refute({{.gain = -2, .change = 10}})) << "nothing is decided by so small a change";
}

TEST(FloorAgreement, WithoutHeldOutLogsNothingContradicts) {
  EXPECT_FALSE(refute({}));
}

}  // namespace
}  // namespace darwinop::gap
