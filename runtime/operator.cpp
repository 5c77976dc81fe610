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

void resetFaults(const RuntimeFiles& files) {
  attachToDaemon(files).commands().fault_reset.ask();
}

void releaseRobot(const RuntimeFiles& files) {
  constexpr Nanos kPatience{3'000'000'000}, kCheckInterval{5'000'000};  // longer than the longest period
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
  // Longer than the longest period: an image that does not change means that the loop hangs.
  constexpr Nanos kPatience{3'000'000'000}, kCheckInterval{5'000'000};
  const Exchange exchange = observeDaemon(files);
  const WakeWord& finished = exchange.block().finished;
  const std::uint32_t before = finished.value();
  const MonotonicClock clock;
  const Nanos end = clock.now() + kPatience;
  while (finished.value() == before) {
    if (clock.now() > end)
      throw std::runtime_error("the runtime (pid " + std::to_string(exchange.block().info.pid) +
                               ") has not run a cycle for 3 s, so nothing is known of the robot; restart it");
    std::this_thread::sleep_for(kCheckInterval);
  }
  Sensors seen;
  (void)exchange.block().sensors.read(seen);
  const LoopInfo& info = exchange.block().info;
  return safety::checkStartPose(seen, safety::startPose(safety::fromSession(info.safety, info.safety_named)));
}

}  // namespace darwinop::runtime
