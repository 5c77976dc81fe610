// Robot link to the loop of a daemon.
#include "runtime/daemon_link.hpp"

#include <unistd.h>

#include <stdexcept>
#include <utility>

#include "runtime/messages.hpp"
#include "runtime/operator.hpp"

namespace darwinop::runtime {
namespace {

FileLock takeLease(const RuntimeFiles& files) {
  if (auto lease = FileLock::tryTake(files.drive_lock, static_cast<gid_t>(-1), FileOwner::kAny))
    return std::move(*lease);
  throw std::runtime_error("another controller (" + pidText(FileLock::holder(files.drive_lock)) +
                           ") drives this robot; end it first, or look on without driving: darwinop runtime --status");
}

}  // namespace

pid_t daemonPid(const RuntimeFiles& files) {
  const pid_t pid = FileLock::holder(files.loop_lock);
  // The lock file remains after its daemon ends, so an unreadable one proves nothing unless the exchange exists.
  return pid == -1 && access(files.exchange.c_str(), F_OK) != 0 ? 0 : pid;
}

DaemonLink::DaemonLink(const RuntimeFiles& files)
    : ExchangeLink{attachToDaemon(files)}, files_{files}, lease_{takeLease(files)} {
  beginSession();
}

DaemonLink::~DaemonLink() {
  if (ends_session_) publishEndOfSession();
}

bool DaemonLink::waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) {
  constexpr Nanos kCheckInterval{100'000'000};
  std::uint32_t seen = block().finished.value();
  Nanos asleep_since = now();
  for (;;) {
    if (stop.load()) return end(kAskedToStop);
    if (exchange().lost()) return end(kExchangeLost);
    if (runtimeEnds()) return end(messages::kRuntimeEnds);
    if (releasedByOperator()) return end(messages::kRobotReleased);
    if (finished(cycle)) return true;
    sleepUntilAfter(seen, kCheckInterval);
    const std::uint32_t value = block().finished.value();
    if (value != seen) {
      seen = value;
      asleep_since = now();
    } else if (now() - asleep_since >= kCheckInterval && !daemonAnswers(asleep_since)) {
      return false;
    }
  }
}

/// A controller that is requested to end sees it once, and may then wait for the cycles of its last steps.
bool DaemonLink::runtimeEnds() {
  const std::uint32_t closing = block().closing.load();
  if (closing == ExchangeBlock::kEnding) return !std::exchange(end_seen_, true);
  return closing != ExchangeBlock::kOpen;
}

/// Called after more than the longest period without a cycle: true if the daemon still runs.
bool DaemonLink::daemonAnswers(Nanos asleep_since) {
  constexpr Nanos kHung{5'000'000'000};
  const std::string pid = std::to_string(info().pid);
  const pid_t living = daemonPid(files_);  // another pid is a later daemon, with another exchange
  if (living != info().pid && living != -1) return end("the runtime (pid " + pid + messages::kRuntimeDied);
  if (now() - asleep_since > kHung)
    return end("the runtime (pid " + pid +
               ") lives but has not run a cycle for 5 s; look at it with: " + "darwinop runtime --status");
  return true;
}

}  // namespace darwinop::runtime
