// Logs that contradict what all of them together suggest.
#include "gap/identify/body/log_agreement.hpp"

#include <gtest/gtest.h>

namespace darwinop::gap {
namespace {

TEST(LogAgreement, ALogThatLosesHalfOfWhatARightEffectWouldGainRefutesIt) {
  EXPECT_TRUE(refutes({.gain = -24.9, .change = 40.1}));
  EXPECT_FALSE(refutes({.gain = -15, .change = 40.1})) << "another effect may hide a part of the gain";
  EXPECT_FALSE(refutes({.gain = 28.2, .change = 66.1}));
}

TEST(LogAgreement, ALogThatTheEffectHardlyChangesDecidesNothing) {
  EXPECT_FALSE(refutes({.gain = -20, .change = 22}));
}

}  // namespace
}  // namespace darwinop::gap
