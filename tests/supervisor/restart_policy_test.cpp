#include "supervisor/restart_policy.hpp"

#include <gtest/gtest.h>

namespace darwinop::supervisor {
namespace {

using namespace std::chrono_literals;
using Verdict = RestartPolicy::Verdict;

using process::Ending;
constexpr Ending kCrash{11, true}, kFailed{1, false}, kTidy{};

TEST(RestartPolicy, AControllerThatEndsNormallyIsNotRestarted) {
  RestartPolicy policy;
  EXPECT_EQ(policy.ended(kTidy, 10s), Verdict::kOver);
}

TEST(RestartPolicy, ASignalAndAnExitCodeAreCrashes) {
  RestartPolicy policy;
  EXPECT_EQ(policy.ended(kCrash, 10s), Verdict::kAgain);
  EXPECT_EQ(policy.ended(kFailed, 20s), Verdict::kAgain);
  EXPECT_EQ(policy.crashes(20s), 2U);
}

TEST(RestartPolicy, TheThirdCrashWithinAMinuteIsTheLast) {
  RestartPolicy policy;
  EXPECT_EQ(policy.ended(kCrash, 10s), Verdict::kAgain);
  EXPECT_EQ(policy.ended(kCrash, 40s), Verdict::kAgain);
  EXPECT_EQ(policy.ended(kCrash, 70s), Verdict::kGivenUp);
}

TEST(RestartPolicy, CrashesFurtherApartRestartIndefinitely) {
  RestartPolicy policy;
  for (Nanos now = 10s; now < 3600s; now += 31s) EXPECT_EQ(policy.ended(kCrash, now), Verdict::kAgain);
}

TEST(RestartPolicy, AfterAQuietTimeThreeCrashesAreNeededAgain) {
  RestartPolicy policy;
  for (int hour = 0; hour < 5; ++hour) EXPECT_EQ(policy.ended(kCrash, hour * 3600s), Verdict::kAgain);
  EXPECT_EQ(policy.ended(kCrash, 4 * 3600s + 1s), Verdict::kAgain);
  EXPECT_EQ(policy.ended(kCrash, 4 * 3600s + 2s), Verdict::kGivenUp);
}

TEST(RestartPolicy, AResetForgetsEarlierCrashes) {
  RestartPolicy policy;
  for (const Nanos now : {1s, 2s, 3s}) (void)policy.ended(kCrash, now);
  policy.forget();
  EXPECT_EQ(policy.crashes(4s), 0U);
  EXPECT_EQ(policy.ended(kCrash, 4s), Verdict::kAgain);
  EXPECT_EQ(policy.ended(kCrash, 5s), Verdict::kAgain);
  EXPECT_EQ(policy.ended(kCrash, 6s), Verdict::kGivenUp);
}

}  // namespace
}  // namespace darwinop::supervisor
