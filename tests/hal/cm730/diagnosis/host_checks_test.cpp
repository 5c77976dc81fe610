// Findings about the computer.
#include "hal/cm730/diagnosis/host_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "support/temporary_folder.hpp"

namespace darwinop::cm730 {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

HostFacts good() {
  HostFacts facts;
  facts.priority = 80;
  facts.clock_resolution = Nanos{1};
  return facts;
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

TEST(HostChecks, AProcessorThatSlowsDownReportsTheRemedy) {
  const TemporaryFolder cpus;
  const auto write = [&](const std::string& cpu, const std::string& governor) {
    std::filesystem::create_directories(cpus / cpu + "/cpufreq");
    std::ofstream{cpus / cpu + "/cpufreq/scaling_governor"} << governor << "\n";
  };
  std::filesystem::create_directory(cpus / "cpuidle");  // no processor
  write("cpu0", "performance");
  HostFacts facts = good();
  facts.governors = cpuGovernors(cpus / "");
  EXPECT_EQ(worst(diagnoseHost(facts)), Level::kOk);
  write("cpu1", "ondemand");
  facts.governors = cpuGovernors(cpus / "");
  const Finding row = diagnoseHost(facts).back();
  EXPECT_TRUE(row.is(Kind::kGovernor));
  EXPECT_EQ(row.level, Level::kWarning);
  EXPECT_THAT(row.what, AllOf(HasSubstr("ondemand"), Not(HasSubstr("performance"))));
  EXPECT_THAT(row.remedy, HasSubstr("scaling_governor"));
}

TEST(HostChecks, AComputerOfConstantSpeedHasNoSuchRow) {
  EXPECT_TRUE(cpuGovernors("/missing").empty());
  EXPECT_EQ(diagnoseHost(good()).size(), 3u);
}

TEST(HostChecks, MeasuringDoesNotChangeTheCallingThread) {
  const HostFacts facts = measureHost(80);
  EXPECT_EQ(facts.priority, 80);
  EXPECT_GT(facts.clock_resolution.count(), 0);
  EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
}

/// 0: a process with this limit measures it.
int statusWithLimit(unsigned long bytes) {
  const pid_t child = fork();
  if (child == 0) {
    const std::array<unsigned long, 2> limit{bytes, bytes};
    if (syscall(SYS_setrlimit, RLIMIT_MEMLOCK, limit.data()) != 0) _exit(2);
    _exit(measureHost(80).memory_limit == std::optional<std::uint64_t>{bytes} ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST(HostChecks, TheLimitOfLockedMemoryIsTheOneOfThisProcess) {
  EXPECT_EQ(statusWithLimit(4096), 0);
  EXPECT_EQ(statusWithLimit(0), 0);
}

}  // namespace
}  // namespace darwinop::cm730
