// Real-time thread of the loop.
#include "runtime/periodic_driver.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "runtime/pacer.hpp"

namespace darwinop::runtime {
namespace {

constexpr int kPriorityRefused = 1, kMemoryRefused = 2;

/// Pre-faults the stack that a cycle may need, so that it is mapped and locked before the first cycle.
[[gnu::noinline]] void touchStack() {
  volatile unsigned char stack[128 * 1024];
  for (std::size_t i = 0; i < sizeof stack; i += 1024) stack[i] = 0;
}

/// Applies to the calling thread. Returns what was refused.
int becomeRealTime(int priority) {
  int refused = 0;
  sched_param parameter{};
  parameter.sched_priority = priority;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) != 0) refused |= kPriorityRefused;
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);  // has an effect without SCHED_FIFO only: 1 ns instead of 50 us
  touchStack();
  // Not MCL_FUTURE: the loop allocates nothing later, and a controller's own allocations would fail at the limit for
  // ordinary users.
  if (mlockall(MCL_CURRENT) != 0) refused |= kMemoryRefused;
  return refused;
}

/// Signal handlers must not run during a cycle. Signals of the thread's own errors (SIGSEGV and others) stay unblocked.
void leaveSignalsToOthers() {
  sigset_t all;
  sigfillset(&all);
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigdelset(&all, own);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

std::string remedyText(int refused) {
  std::string what = "the kernel refused ";
  if (refused & kPriorityRefused) what += "real-time priority";
  if (refused == (kPriorityRefused | kMemoryRefused)) what += " and ";
  if (refused & kMemoryRefused) what += "locked memory";
  return what +
         ", so cycles may come late when the machine is busy. Allow it once, then log in again:\n"
         "  printf '%s - rtprio 90\\n%s - memlock unlimited\\n' \"$USER\" \"$USER\" | "
         "sudo tee /etc/security/limits.d/darwinop.conf\n"
         "or run as root.";
}

}  // namespace

RealTime realTimeFromText(const std::string& text) {
  if (text == "required") return RealTime::kRequired;
  if (text == "if-allowed" || text.empty()) return RealTime::kIfAllowed;
  throw std::runtime_error("real time can be \"required\" or \"if-allowed\" (DARWINOP_REALTIME, --realtime), not \"" +
                           text + "\"");
}

RealTime realTimeFromEnvironment() {
  const char* value = std::getenv("DARWINOP_REALTIME");
  return realTimeFromText(value == nullptr ? "" : value);
}

PeriodicDriver::PeriodicDriver(Loop& loop, Clock& clock, Nanos period, const RealTimeConfig& config)
    : loop_{loop}, clock_{clock}, period_{period}, thread_{[this, &config] { run(config.priority); }} {
  refused_.wait(-1);
  const int refused = refused_.load();
  if (refused != 0) warning_ = remedyText(refused);
  const bool go = refused == 0 || config.demand == RealTime::kIfAllowed;
  start_.store(go ? Start::kGo : Start::kAbandon);
  start_.notify_one();
  if (go) return;
  thread_.join();
  throw std::runtime_error(warning_ + " To go on without, waive it: DARWINOP_REALTIME=if-allowed");
}

PeriodicDriver::~PeriodicDriver() {
  stop_.store(true, std::memory_order_relaxed);
  thread_.join();
}

void PeriodicDriver::run(int priority) noexcept {
  pthread_setname_np(pthread_self(), "darwinop-loop");
  leaveSignalsToOthers();
  refused_.store(becomeRealTime(priority));
  refused_.notify_one();
  start_.wait(Start::kPending);
  if (start_.load() == Start::kAbandon) return;
  Pacer pacer{clock_, period_};
  while (!stop_.load(std::memory_order_relaxed)) loop_.step(pacer);
}

}  // namespace darwinop::runtime
