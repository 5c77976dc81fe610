// What a person may ask of a running daemon.
#include "runtime/operator.hpp"

#include <memory>
#include <stdexcept>

#include "runtime/clock.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/report.hpp"

namespace darwinop::runtime {

namespace {
Exchange attachAs(Exchange::Access access, const RuntimeFiles& files) {
  Exchange exchange = Exchange::attach(files.exchange, access);
  if (FileLock::holder(files.loop_lock) == 0)
    throw std::runtime_error("the runtime (pid " + std::to_string(exchange.block().info.pid) +
                             ") has ended; start it again with: darwinop runtime");
  return exchange;
}
}  // namespace

Exchange attachToDaemon(const RuntimeFiles& files) {
  return attachAs(Exchange::Access::kUse, files);
}

Exchange lookAtDaemon(const RuntimeFiles& files) {
  return attachAs(Exchange::Access::kLook, files);
}

std::string daemonStatus(const RuntimeFiles& files) {
  const Exchange exchange = attachToDaemon(files);
  const ExchangeBlock& block = exchange.block();
  const pid_t driver = FileLock::holder(files.drive_lock);
  const auto stats = std::make_unique<StatsView>();
  block.stats.copyTo(*stats);
  Sensors last;
  const bool any = block.sensors.read(last);
  std::string text = "runtime       pid " + std::to_string(block.info.pid) + ", " + block.info.robot + " on " +
                     block.info.port + "\n" + "driver        " +
                     (driver == 0  ? "none"
                      : driver < 0 ? "of another user"
                                   : "pid " + std::to_string(driver)) +
                     ", session " + std::to_string(block.session.load()) + "\n";
  // The last session is the operator's own: no controller has come since.
  const std::uint32_t released = block.released.load();
  const bool limp = released != 0 && released == block.session.load() && last.safety.state != State::kOffline;
  if (any) text += robotText(last, limp ? "released by an operator; joints are limp until a controller starts" : "");
  return text + reportText(*stats, last);
}

void resetFaults(const RuntimeFiles& files) {
  attachToDaemon(files).block().fault_resets.fetch_add(1);
}

void releaseRobot(const RuntimeFiles& files) {
  const Exchange exchange = attachToDaemon(files);
  exchange.block().released.store(exchange.block().session.fetch_add(1) + 1);
}

safety::StartPoseCheck startPoseNow(const RuntimeFiles& files) {
  // Longer than the longest period: an image that does not change is one of a loop that hangs.
  constexpr Nanos kPatience{3'000'000'000}, kLook{100'000'000};
  const Exchange exchange = attachToDaemon(files);
  WakeWord& finished = exchange.block().finished;
  const std::uint32_t before = finished.value();
  const MonotonicClock clock;
  const Nanos end = clock.now() + kPatience;
  while (finished.value() == before) {
    if (clock.now() > end)
      throw std::runtime_error("the runtime (pid " + std::to_string(exchange.block().info.pid) +
                               ") has not run a cycle for 3 s, so nothing is known of the robot; restart it");
    finished.waitWhile(before, kLook);
  }
  Sensors seen;
  (void)exchange.block().sensors.read(seen);
  return safety::checkStartPose(seen);
}

}  // namespace darwinop::runtime
