// Findings about the computer.
#include "hal/cm730/diagnosis/host_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <cerrno>
#include <cstring>

namespace darwinop::cm730 {
namespace {

using testing::AllOf;
using testing::HasSubstr;

HostFacts good() {
  return {.priority = 80, .priority_error = 0, .memory_error = 0, .memory_limit = {}, .clock_resolution = Nanos{1}};
}

TEST(HostChecks, AComputerThatPermitsEverythingPasses) {
  const Findings rows = diagnoseHost(good());
  EXPECT_EQ(rows.size(), 3u);
  EXPECT_EQ(worst(rows), Level::kOk);
}

TEST(HostChecks, RefusedPriorityReportsTheRemedy) {
  HostFacts facts = good();
  facts.priority_error = EPERM;
  const Finding row = diagnoseHost(facts)[0];
  EXPECT_EQ(row.level, Level::kWarning);
  EXPECT_TRUE(row.is(Kind::kPriority));
  EXPECT_THAT(row.what, AllOf(HasSubstr(" 80 "), HasSubstr(std::strerror(EPERM))));
  EXPECT_THAT(row.remedy, AllOf(HasSubstr("rtprio 90\""), HasSubstr("/etc/security/limits.d/darwinop.conf")));
}

TEST(HostChecks, RefusedLockingReportsTheLimit) {
  HostFacts facts = good();
  facts.memory_error = ENOMEM;
  facts.memory_limit = 8192 * 1024;
  const Finding row = diagnoseHost(facts)[1];
  EXPECT_EQ(row.level, Level::kWarning);
  EXPECT_TRUE(row.is(Kind::kMemory));
  EXPECT_THAT(row.what, HasSubstr("8192 KiB"));
  EXPECT_THAT(row.remedy, AllOf(HasSubstr("memlock "), HasSubstr("/etc/security/limits.d/darwinop.conf")));
}

TEST(HostChecks, AClockWithTickResolutionIsTooCoarse) {
  HostFacts facts = good();
  facts.clock_resolution = Nanos{4'000'000};
  EXPECT_EQ(diagnoseHost(facts)[2].level, Level::kError);
}

TEST(HostChecks, MeasuringDoesNotChangeTheCallingThread) {
  const HostFacts facts = measureHost(80);
  EXPECT_EQ(facts.priority, 80);
  EXPECT_GT(facts.clock_resolution.count(), 0);
  EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
}

}  // namespace
}  // namespace darwinop::cm730
