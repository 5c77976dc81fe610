// SplitMix64 against its reference output.
#include "core/random.hpp"

#include <gtest/gtest.h>

namespace darwinop {
namespace {

// Source: splitmix64.c by Sebastiano Vigna (public domain), seed 1234567.
TEST(Random, EqualsTheReferenceImplementation) {
  Rng rng{1234567};
  for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U})
    EXPECT_EQ(rng.next(), expected);
}

TEST(Random, UniformNumbersAreFromZeroToBelowOne) {
  EXPECT_EQ(uniformFrom(0), 0);
  EXPECT_LT(uniformFrom(~std::uint64_t{0}), 1);
}

}  // namespace
}  // namespace darwinop
