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

TEST(LogAgreement, ALogThatNeitherModelExplainsDecidesLess) {
  const LogGain right{.gain = -60, .change = 80, .cost = 160, .samples = 100};
  EXPECT_TRUE(refutes(right));
  LogGain poor = right;
  poor.cost = 460;  // and 400 without the effect: four a sample
  EXPECT_FALSE(refutes(poor));
  poor.change = poor.expected = 101, poor.gain = 70;
  EXPECT_FALSE(supports(poor)) << "what is left by the better model counts: 4.6 a sample";
}

// Residuals of 20 sigma, which the robust cost weighs less than a square.
TEST(LogAgreement, ALogSupportsATrueEffectHoweverLargeItsResidualsWere) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(100), large = Eigen::VectorXd::Constant(100, 20);
  EXPECT_TRUE(supports(gainOf(large, none)));
  EXPECT_FALSE(supports(gainOf(none, large)));
  EXPECT_FALSE(supports(gainOf(large, -large))) << "as far off as before, to the other side";
}

TEST(LogAgreement, AnEffectThatRuinsALogIsRefutedByIt) {
  EXPECT_TRUE(refutes({.gain = -2000, .change = 2400, .cost = 2100, .samples = 100}));
}

}  // namespace
}  // namespace darwinop::gap
