// Operator commands to a running supervisor.
#include "supervisor/ask.hpp"

#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>

#include "core/text/number_text.hpp"
#include "core/text/printable.hpp"
#include "runtime/exchange.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/rest.hpp"
#include "safety/config.hpp"
#include "supervisor/messages.hpp"
#include "supervisor/orders.hpp"
#include "supervisor/status.hpp"

namespace darwinop::supervisor {
namespace {

// Same numbers on all architectures; older headers lack them.
constexpr long kPidfdSendSignal = 424, kPidfdOpen = 434;

// A controller gets 3 s to end, a crouch at the usual gentle speed takes 13 s at most, and two kill timeouts may
// follow.
constexpr Nanos kPatience{60'000'000'000};
// Beside a slow crouch.
constexpr Nanos kMargin{20'000'000'000};
constexpr Nanos kCheckInterval{20'000'000};

pid_t runningOne(const runtime::RuntimeFiles& files) {
  return runtime::FileLock::provenHolder(SupervisorFiles{files}.lock);
}

int noneRuns(int code) {
  std::cout << messages::kNoSupervisor << '\n';
  return code;
}

/// Signals the process that holds the lock. The pidfd is opened before the lock is checked again, so that a later
/// process with the same pid is not signalled. Linux before 5.3 has no pidfd.
bool signalHolder(const runtime::RuntimeFiles& files, pid_t supervisor, int signal) {
  const Descriptor handle{static_cast<int>(syscall(kPidfdOpen, supervisor, 0))};
  if (runningOne(files) != supervisor) return true;  // it has ended: no process to signal
  if (handle.fd() >= 0) return syscall(kPidfdSendSignal, handle.fd(), signal, nullptr, 0) == 0 || errno == ESRCH;
  return kill(supervisor, signal) == 0 || errno == ESRCH;
}

void order(const runtime::RuntimeFiles& files, pid_t supervisor, int signal) {
  if (!signalHolder(files, supervisor, signal))
    throw std::runtime_error("cannot reach the supervisor (pid " + std::to_string(supervisor) +
                             "): " + std::strerror(errno) + "; retry with sudo");
}

bool becomesTrue(const std::function<bool()>& condition, Nanos patience, runtime::Clock& clock) {
  const Nanos end = clock.now() + patience;
  while (!condition()) {
    if (clock.now() > end) return false;
    clock.sleepUntil(clock.now() + kCheckInterval);
  }
  return true;
}

/// Time in which a robot sits down, even with the lowest gentle_speed of the session that drives.
Nanos timeToStop(const runtime::RuntimeFiles& files) {
  Sensors seen;
  try {
    (void)runtime::Exchange::attach(files.exchange, runtime::Exchange::Access::kRead).block().sensors.read(seen);
  } catch (const std::runtime_error&) {  // no loop runs, or this user may not look at it
  }
  const double speed = static_cast<double>(seen.safety.gentle_speed);
  if (!(speed >= safety::kLeastGentleSpeed)) return kPatience;  // unknown
  return std::max(kPatience, runtime::Rest::atMost(speed) + kMargin);
}

/// The last supervisor has recorded it. Prints why not: joints that may be under torque, or no such record.
bool robotIsAtRest(const runtime::RuntimeFiles& files) {
  const std::string path = SupervisorFiles{files}.status;
  const auto status = readStatus(path);
  if (status && status->at_rest) return true;
  std::cout << (status && !status->left.empty() ? status->left : messages::kNoRecordOfRest + path) << '\n';
  return false;
}

/// A supervisor has run since the computer was started.
bool hasRun(const runtime::RuntimeFiles& files) {
  return access(SupervisorFiles{files}.lock.c_str(), F_OK) == 0;
}

std::string stateOf(const runtime::RuntimeFiles& files) {
  const auto status = readStatus(SupervisorFiles{files}.status);
  return status ? status->state : "unknown";
}

/// Sends the command and waits until the supervisor has taken it and `done` holds.
int carryOut(const runtime::RuntimeFiles& files, int signal, const std::function<bool(const Status&)>& done) {
  const pid_t pid = runningOne(files);
  if (pid == 0) return noneRuns(1);
  const std::string path = SupervisorFiles{files}.status;
  const auto before = readStatus(path);
  const std::uint32_t orders = before ? before->orders : 0;
  order(files, pid, signal);
  bool ended = false;
  const auto taken = [&] {
    ended = runningOne(files) != pid;
    const auto status = readStatus(path);
    return ended || (status && status->orders != orders && done(*status));
  };
  runtime::MonotonicClock clock;
  const bool carried_out = becomesTrue(taken, kPatience, clock);
  if (ended) throw std::runtime_error(messages::kEndedBefore);
  if (!carried_out)
    throw std::runtime_error("the supervisor (pid " + std::to_string(pid) +
                             ") has not completed the command within a minute; its state: " + stateOf(files));
  std::cout << stateOf(files) << '\n';
  return 0;
}

/// Holder of the lease, with the program's name from the kernel (15 characters), which the program chooses.
std::string driver(const runtime::RuntimeFiles& files) {
  const pid_t pid = runtime::FileLock::holder(files.drive_lock);
  if (pid == 0) return "none";
  if (pid < 0) return "of another user";
  std::string name;
  std::ifstream file{"/proc/" + std::to_string(pid) + "/comm"};
  std::getline(file, name);
  return "pid " + std::to_string(pid) + (name.empty() ? "" : ", " + text::printable(name));
}

std::string process(pid_t pid) {
  return pid == 0 ? "does not run" : "pid " + std::to_string(pid);
}

}  // namespace

int printStatus(const runtime::RuntimeFiles& files) {
  const pid_t pid = runningOne(files);
  if (pid == 0) return noneRuns(1);
  const auto status = readStatus(SupervisorFiles{files}.status);
  std::cout << "supervisor    pid " << pid << '\n';
  if (!status) {
    std::cout << "state         starting\n";
    return 0;
  }
  const std::string name = status->controller.empty() ? "none" : status->controller;
  std::cout << "home          " << status->home << "\nstate         " << status->state << "\nruntime       "
            << process(status->runtime_pid) << "\ncontroller    " << name << ", " << process(status->controller_pid)
            << ", crashes within a minute: " << status->crashes << "\ndriver        " << driver(files) << '\n';
  return 0;
}

int stopSupervisor(const runtime::RuntimeFiles& files) {
  runtime::MonotonicClock clock;
  return stopSupervisor(files, clock);
}

int stopSupervisor(const runtime::RuntimeFiles& files, runtime::Clock& clock) {
  const pid_t pid = runningOne(files);
  if (pid == 0) return noneRuns(!hasRun(files) || robotIsAtRest(files) ? 0 : 1);
  const Nanos patience = timeToStop(files);
  order(files, pid, SIGTERM);
  // The kernel releases the lock when the process is gone.
  if (!becomesTrue([&] { return runningOne(files) != pid; }, patience, clock))
    throw std::runtime_error("the supervisor (pid " + std::to_string(pid) + ") has not ended within " +
                             text::inSeconds(patience) + "; its state: " + stateOf(files));
  std::cout << "the supervisor has ended\n";
  return robotIsAtRest(files) ? 0 : 1;
}

int stopController(const runtime::RuntimeFiles& files) {
  return carryOut(files, kStopControllerSignal, [](const Status& status) { return status.controller_ended; });
}

int restartController(const runtime::RuntimeFiles& files) {
  return carryOut(files, kRestartControllerSignal, [](const Status& status) { return !status.stopping; });
}

}  // namespace darwinop::supervisor
