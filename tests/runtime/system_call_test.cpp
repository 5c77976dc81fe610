// The loop's thread asks the kernel for one thing per cycle: to sleep until the next release. Counted by ptrace.
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "child.hpp"
#include "fake_bus.hpp"
#include "runtime/threaded_link.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

pid_t loopThreadOf(pid_t process) {
  for (const auto& task : std::filesystem::directory_iterator{"/proc/" + std::to_string(process) + "/task"}) {
    std::string name;
    std::getline(std::ifstream{task.path() / "comm"}, name);
    if (name == "darwinop-loop") return std::stoi(task.path().filename());
  }
  return 0;
}

long request(unsigned what, pid_t thread, std::uintptr_t address = 0, void* data = nullptr) {
  return ptrace(static_cast<__ptrace_request>(what), thread, reinterpret_cast<void*>(address), data);
}

/// What the thread asks for in its next `count` system calls, by number.
std::map<std::uint64_t, int> countCalls(pid_t thread, int count) {
  std::map<std::uint64_t, int> calls;
  int status = 0;
  void* const traced = reinterpret_cast<void*>(PTRACE_O_TRACESYSGOOD);
  if (request(PTRACE_SEIZE, thread, 0, traced) != 0 || request(PTRACE_INTERRUPT, thread) != 0) return calls;
  while (waitpid(thread, &status, __WALL) == thread && WIFSTOPPED(status)) {
    struct __ptrace_syscall_info info {};
    const bool entered = WSTOPSIG(status) == (SIGTRAP | 0x80) &&
                         request(PTRACE_GET_SYSCALL_INFO, thread, sizeof info, &info) > 0 &&
                         info.op == PTRACE_SYSCALL_INFO_ENTRY;
    if (entered) ++calls[info.entry.nr], --count;
    request(count > 0 ? PTRACE_SYSCALL : PTRACE_DETACH, thread);
    if (count == 0) break;
  }
  return calls;
}

TEST(LoopThread, MakesNoSystemCallButItsSleep) {
  const TemporaryFolder folder;
  const Child child{[&] {
    LoopConfig config;
    config.period = std::chrono::milliseconds{2};
    config.record_path = folder / "log.csv";
    static ThreadedLink link{config, std::make_unique<FakeBus>()};
    const std::atomic<bool> stop{false};
    for (int i = 0; i < 50; ++i) {
      link.publish({});
      (void)link.waitForCycle(link.sensors().cycle + 1, stop);
    }
    // For a few cycles more the loop wakes sleepers who may have been late to say so.
    for (const std::uint64_t last = link.sensors().cycle + 10; link.sensors().cycle < last;) usleep(2'000);
  }};
  const std::map<std::uint64_t, int> calls = countCalls(loopThreadOf(child.pid()), 200);
  if (calls.empty()) GTEST_SKIP() << "this machine does not let a process be traced";
  constexpr std::uint64_t kSleepWith64BitTime = 407;  // i386 only
  for (const auto& [number, times] : calls)
    EXPECT_TRUE(number == SYS_clock_nanosleep || number == kSleepWith64BitTime || number == SYS_restart_syscall)
        << "system call " << number << ", " << times << " times in 200";
}

}  // namespace
}  // namespace darwinop::runtime
