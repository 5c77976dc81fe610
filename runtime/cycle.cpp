#include "runtime/cycle.hpp"

#include <algorithm>

#include "runtime/merge.hpp"

namespace darwinop::runtime {
namespace {

/// A servo that restarts answers after about 0.2 s: in a shorter stall it misses a reply, which is noticed anyway.
constexpr Nanos kSoonestAnswer{150'000'000};

}  // namespace

Cycle::Cycle(ServoBus& bus, safety::Guard& guard, Nanos period) : bus_{bus}, guard_{guard} {
  sensors_.period_ns = period.count();
}

void Cycle::run(const Commands& asked, const CycleTime& time) noexcept {
  noteStall(time);
  const SafeCommands safe = guard_.vet(asked, sensors_);  // every command passes through the safety layer
  bus_.write(safe);                                       // one SyncWrite; in rare cases two
  bus_.read(readings_);                                   // one BulkRead
  noteCommanded(safe, sensors_);                          // adds the goals sent to the sensor image
  merge(readings_, sensors_);  // devices without a reply keep their values; their age increases
  account(time);
}

/// While the loop stood still (a debugger, SIGSTOP, a paused virtual machine) servos may have restarted: what was read
/// before is then as old as after an outage of the bus. Readings count from the start of their cycle, because a stall
/// may lie between request and reply.
void Cycle::noteStall(const CycleTime& time) noexcept {
  const Nanos gone = time.release + time.wake_latency - began_;
  began_ += gone;
  if (sensors_.cycle == 0 || gone < kSoonestAnswer) return;
  const std::int64_t missed = std::max<std::int64_t>(gone.count() / sensors_.period_ns - 1, kAnswerPatience + 1);
  missCycles(static_cast<std::uint32_t>(std::min<std::int64_t>(missed, Freshness::kNever)), sensors_);
}

void Cycle::account(const CycleTime& time) noexcept {
  ++sensors_.cycle;
  sensors_.time_ns = time.release.count();
  sensors_.wake_latency_ns = time.wake_latency.count();
  sensors_.slack_ns = time.slack.count();
  sensors_.overruns = time.overruns;
  sensors_.safety = guard_.report();
}

}  // namespace darwinop::runtime
