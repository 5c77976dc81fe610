// The cycle may enter the kernel to write, to wait for and to read bytes of the serial line, and for nothing else.
// The kernel itself is the judge: any other system call of the loop's thread ends the process.
#include <gtest/gtest.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <thread>

#include "hal/cm730/bus.hpp"
#include "hal/cm730/serial_port.hpp"
#include "hil-mocks/pty_host.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"

namespace darwinop {
namespace {

constexpr Nanos kPeriod{16'000'000};

#define ALLOW(call) BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (call), 0, 1), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)

/// From here on this thread may make the calls of a cycle, and end.
bool lockDown() {
  sock_filter filter[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                          ALLOW(SYS_write),
                          ALLOW(SYS_read),
                          ALLOW(SYS_ppoll),
                          ALLOW(SYS_poll),
                          ALLOW(SYS_exit_group),
                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS)};
  const sock_fprog program{static_cast<unsigned short>(std::size(filter)), filter};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

Commands swinging(std::uint64_t cycle) {
  Commands asked;
  asked.session = 1;
  asked.sequence = cycle;
  asked.start_where_it_is = true;
  asked.led.setEye(static_cast<std::uint16_t>(cycle & 0x7FFF));
  for (JointCommand& joint : asked.joint) joint.setGoal(Rad{0.0001 * static_cast<double>(cycle % 100)});
  return asked;
}

enum Outcome { kWell = 0, kNotDriven = 3, kNoFilter = 4, kStray = 5 };

/// In the child: drives the robot on `port`; ends with an Outcome, or is killed by the filter.
[[noreturn]] void drive(const std::string& port, bool stray) {
  while (!std::filesystem::exists(port)) std::this_thread::sleep_for(std::chrono::milliseconds{5});
  cm730::SerialPort line{port};
  cm730::Cm730Bus bus{line, cm730::BusConfig::forPeriod(kPeriod)};
  safety::Guard guard{safety::Config{}};
  runtime::Cycle cycle{bus, guard, kPeriod};
  std::uint64_t count = 0;
  while (count < 20) cycle.run(swinging(++count), {});
  if (!lockDown()) _exit(kNoFilter);
  while (count < 300) cycle.run(swinging(++count), {});  // back to back: takeover, goals, LEDs, polls
  if (stray) (void)getppid();
  _exit(cycle.sensors().safety.state == State::kDriven ? kWell : kNotDriven);
}

int statusOfChild(bool stray) {
  const std::string folder = std::filesystem::temp_directory_path() / ("darwinop-calls-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const std::string port = folder + "/port";
  const pid_t child = fork();
  if (child == 0) drive(port, stray);
  int status = 0;
  {
    hil::VirtualRobot robot;
    const hil::PtyHost host{robot, {port, Nanos{0}}};
    waitpid(child, &status, 0);
  }
  std::filesystem::remove_all(folder);
  return status;
}

TEST(SystemCalls, ACycleWritesWaitsAndReadsAndNothingElse) {
  const int status = statusOfChild(false);
  ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status) << ": a system call that no cycle may make";
  EXPECT_EQ(WEXITSTATUS(status), kWell);
}

TEST(SystemCalls, TheJudgeOfThisTestNoticesAStrayOne) {
  const int status = statusOfChild(true);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGSYS);
}

}  // namespace
}  // namespace darwinop
