// Measures real-time priority, memory locking, processor speed and clock resolution.
#include "hal/cm730/diagnosis/host_checks.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace darwinop::cm730 {
namespace {

// Without high-resolution timers, the kernel reports its tick of 1 to 10 ms.
constexpr Nanos kFineClock{1'000};

// Size of a controller process with its libraries and thread stacks; the usual limit of 8 MB is too small.
constexpr std::size_t kLockedBytes = 48 * 1024 * 1024;

constexpr const char* kLimitsFile = "/etc/security/limits.d/darwinop.conf";

int tryPriority(int priority) {
  int error = 0;
  std::thread{[&] {
    sched_param wanted{};
    wanted.sched_priority = priority;
    error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wanted);
  }}.join();
  return error;
}

int tryLocking() {
  void* const memory = ::mmap(nullptr, kLockedBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return errno;
  const int error = ::mlock(memory, kLockedBytes) == 0 ? 0 : errno;
  ::munmap(memory, kLockedBytes);
  return error;
}

std::string limitLine(const std::string& line) {
  return "echo \"$USER - " + line + "\" | sudo tee -a " + kLimitsFile + "   (then log out and in again)";
}

Finding priorityRow(const HostFacts& facts) {
  const std::string name = "real-time priority " + std::to_string(facts.priority);
  if (facts.priority_error == 0) return Finding::ok(name + " is permitted");
  return Finding::of(Kind::kPriority,
                     name + " is refused (" + std::strerror(facts.priority_error) + "): cycles may be late",
                     limitLine("rtprio 90"));
}

Finding memoryRow(const HostFacts& facts) {
  if (facts.memory_error == 0) return Finding::ok("locking memory is permitted");
  std::string what = "locking memory is refused (" + std::string{std::strerror(facts.memory_error)} + ")";
  if (facts.memory_limit) what += ", the limit is " + std::to_string(*facts.memory_limit / 1024) + " KiB";
  return Finding::of(Kind::kMemory, what + ": a page fault could stall the loop", limitLine("memlock unlimited"));
}

// Any other governor lowers the speed while a loop sleeps; the next cycle begins slowly.
constexpr const char* kConstantSpeed = "performance";

Findings governorRows(const std::set<std::string>& governors) {
  if (governors.empty()) return {};
  std::string slowing;
  for (const std::string& governor : governors)
    if (governor != kConstantSpeed) slowing += (slowing.empty() ? "" : ", ") + governor;
  if (slowing.empty()) return {Finding::ok("the processor keeps its speed")};
  return {Finding::of(Kind::kGovernor,
                      "the processor slows down when idle (governor " + slowing + "): cycles may be late",
                      std::string{"echo "} + kConstantSpeed + " | sudo tee " + kSysCpu +
                          "/cpu*/cpufreq/scaling_governor   (after each boot: docs/doctor.md)")};
}

}  // namespace

std::set<std::string> cpuGovernors(const std::string& folder) {
  std::set<std::string> found;
  std::error_code none;  // without sysfs nothing is known
  for (const auto& entry : std::filesystem::directory_iterator{folder, none}) {
    std::ifstream file{entry.path() / "cpufreq/scaling_governor"};
    if (std::string governor; file >> governor) found.insert(governor);
  }
  return found;
}

/// Bytes that this process may lock; nothing: as many as it likes. getrlimit() of the C library asks with prlimit64,
/// which the robot's Linux 2.6.31 does not have.
std::optional<std::uint64_t> lockingLimit() {
#ifdef SYS_ugetrlimit  // 32 bits: SYS_getrlimit is a still older call
  constexpr long kCall = SYS_ugetrlimit;
#else
  constexpr long kCall = SYS_getrlimit;
#endif
  constexpr auto kUnlimited = ~0UL;
  std::array<unsigned long, 2> present_and_most{};
  if (::syscall(kCall, RLIMIT_MEMLOCK, present_and_most.data()) != 0 || present_and_most[0] == kUnlimited) return {};
  return present_and_most[0];
}

Nanos clockResolution() {
  timespec resolution{};
  ::clock_getres(CLOCK_MONOTONIC, &resolution);
  return std::chrono::seconds{resolution.tv_sec} + Nanos{resolution.tv_nsec};
}

Finding clockRow(Nanos resolution) {
  const std::string what = "clock resolution " + std::to_string(resolution.count()) + " ns";
  if (resolution <= kFineClock) return Finding::ok(what);
  return Finding::of(Kind::kClockCoarse, what + ": too coarse for a 16 ms loop",
                     "boot a kernel with high-resolution timers (CONFIG_HIGH_RES_TIMERS), without highres=off");
}

HostFacts measureHost(int priority) {
  HostFacts facts;
  facts.priority = priority;
  facts.priority_error = tryPriority(priority);
  facts.memory_error = tryLocking();
  facts.memory_limit = lockingLimit();
  facts.governors = cpuGovernors();
  facts.clock_resolution = clockResolution();
  return facts;
}

Findings diagnoseHost(const HostFacts& facts) {
  Findings rows{priorityRow(facts), memoryRow(facts), clockRow(facts.clock_resolution)};
  for (Finding& row : governorRows(facts.governors)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace darwinop::cm730
