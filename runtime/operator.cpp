// Operator commands to a running daemon.
#include "runtime/operator.hpp"

#include <string.h>

#include <memory>
#include <stdexcept>
#include <thread>

#include "core/text/printable.hpp"
#include "runtime/clock.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/messages.hpp"
#include "runtime/report.hpp"
#include "safety/fault_book.hpp"

namespace darwinop::runtime {

namespace {

constexpr Nanos kPatience{3'000'000'000};  // longer than the longest period
constexpr Nanos kCheckInterval{5'000'000};

Exchange attachAs(Exchange::Access access, const RuntimeFiles& files) {
  Exchange exchange = Exchange::attach(files.exchange, access);
  if (FileLock::holder(files.loop_lock) == 0)
    throw std::runtime_error("the runtime (pid " + std::to_string(exchange.block().info.pid) +
                             messages::kRuntimeHasEnded);
  return exchange;
}

/// Input is untrusted: any process of the runtime's group can write it.
template <std::size_t N>
std::string shown(const char (&text)[N]) {
  return text::printable({text, strnlen(text, N)});
}

/// Image of a cycle that ends at least so many cycles after number `before`. Throws std::runtime_error if none does for
/// longer than the longest period: the loop hangs.
Sensors imageAfter(const Exchange& exchange, std::uint32_t before, std::uint32_t cycles) {
  const WakeWord& finished = exchange.block().finished;
  const MonotonicClock clock;
  const Nanos end = clock.now() + kPatience;
  while (finished.value() - before < cycles) {
    if (clock.now() > end)
      throw std::runtime_error("the runtime (pid " + std::to_string(exchange.block().info.pid) + messages::kLoopHangs);
    std::this_thread::sleep_for(kCheckInterval);
  }
  Sensors seen;
  (void)exchange.block().sensors.read(seen);
  return seen;
}
}  // namespace

Exchange attachToDaemon(const RuntimeFiles& files) {
  return attachAs(Exchange::Access::kUse, files);
}

Exchange observeDaemon(const RuntimeFiles& files) {
  return attachAs(Exchange::Access::kRead, files);
}

std::string daemonStatus(const RuntimeFiles& files) {
  const Exchange exchange = observeDaemon(files);
  const ExchangeBlock& block = exchange.block();
  const pid_t driver = FileLock::holder(files.drive_lock);
  const auto stats = std::make_unique<StatsView>();
  block.stats.copyTo(*stats);
  Sensors last;
  const bool any = block.sensors.read(last);
  std::string text = "runtime       pid " + std::to_string(block.info.pid) + ", " + shown(block.info.robot) + " on " +
                     shown(block.info.port) + "\n" + "driver        " +
                     (driver == 0  ? "none"
                      : driver < 0 ? "of another user"
                                   : "pid " + std::to_string(driver)) +
                     ", session " + std::to_string(block.session.load()) + "\n";
  if (any) text += robotText(last);
  return text + reportText(*stats, last);
}

void requestFaultReset(const RuntimeFiles& files) {
  attachToDaemon(files).commands().fault_reset.ask();
}

void resetFaults(const RuntimeFiles& files) {
  const Exchange exchange = attachToDaemon(files);
  const std::uint32_t before = exchange.block().finished.value();
  exchange.commands().fault_reset.ask();
  // The cycle that runs meanwhile may have read the requests already; the next one has not.
  const Sensors seen = imageAfter(exchange, before, 2);
  std::string remain;
  safety::forEachFault(seen.safety.active & safety::kLatchedFaults, [&](std::size_t i) {
    const FaultRow& fault = kFaultTable[i];
    remain += "\n  fault " + std::to_string(static_cast<int>(fault.fault)) + " " + std::string{fault.name} + ": " +
              std::string{fault.meaning} + "; " + std::string{fault.remedy};
  });
  if (!remain.empty()) throw std::runtime_error(messages::kCausesPersist + remain);
}

void releaseRobot(const RuntimeFiles& files) {
  const Exchange exchange = attachToDaemon(files);
  const MonotonicClock clock;
  const Nanos end = clock.now() + kPatience;
  exchange.commands().release.ask();
  Sensors seen;
  const auto taken = [&] { return seen.safety.active[safety::rowIndex(Fault::kReleasedByOperator)]; };
  while (!taken() || seen.safety.state == State::kOffline) {  // offline, nothing is sent
    if (clock.now() > end)
      throw std::runtime_error(taken() ? messages::kReleasedInSilence
                                       : "the runtime (pid " + std::to_string(exchange.block().info.pid) +
                                             messages::kNotReleased);
    std::this_thread::sleep_for(kCheckInterval);
    (void)exchange.block().sensors.read(seen);
  }
}

safety::StartPoseCheck startPoseNow(const RuntimeFiles& files) {
  const Exchange exchange = observeDaemon(files);
  const Sensors seen = imageAfter(exchange, exchange.block().finished.value(), 1);
  const LoopInfo& info = exchange.block().info;
  return safety::checkStartPose(seen, safety::startPose(safety::fromSession(info.safety, info.safety_named)));
}

}  // namespace darwinop::runtime
