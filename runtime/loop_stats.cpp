// Timing and link statistics of the loop.
#include "runtime/loop_stats.hpp"

namespace darwinop::runtime {
namespace {
constexpr auto kRelaxed = std::memory_order_relaxed;
}

void LoopStats::account(const Sensors& sensors, std::uint32_t skipped, Timed timed) noexcept {
  const std::uint32_t cycles = cycles_.load(kRelaxed) + 1;
  if (timed == Timed::kYes) {
    wake_.add(Nanos{sensors.wake_latency_ns});
    if (cycles > 1) slack_.add(Nanos{sensors.slack_ns});  // of the previous cycle
    if (sensors.wire.bus_ns > 0) bus_.add(Nanos{sensors.wire.bus_ns});
  }
  if (sensors.wire.wire_ns > 0) wire_.add(Nanos{sensors.wire.wire_ns});
  overruns_.store(sensors.overruns, kRelaxed);
  skipped_.store(skipped, kRelaxed);
  retries_.store(sensors.link.retries, kRelaxed);
  incomplete_.store(sensors.link.incomplete, kRelaxed);
  late_replies_.store(sensors.link.late_replies, kRelaxed);
  reconnects_.store(sensors.link.reconnects, kRelaxed);
  cycles_.store(cycles, kRelaxed);
}

void LoopStats::copyTo(StatsView& view) const noexcept {
  view.cycles = cycles_.load(kRelaxed);
  view.overruns = overruns_.load(kRelaxed);
  view.skipped = skipped_.load(kRelaxed);
  view.retries = retries_.load(kRelaxed);
  view.incomplete = incomplete_.load(kRelaxed);
  view.late_replies = late_replies_.load(kRelaxed);
  view.reconnects = reconnects_.load(kRelaxed);
  wake_.copyTo(view.wake);
  bus_.copyTo(view.bus);
  wire_.copyTo(view.wire);
  slack_.copyTo(view.slack);
}

StatsView StatsView::since(const StatsView& before) const {
  StatsView d = *this;
  d.cycles -= before.cycles;
  d.overruns -= before.overruns;
  d.skipped -= before.skipped;
  d.retries -= before.retries;
  d.incomplete -= before.incomplete;
  d.late_replies -= before.late_replies;
  d.reconnects -= before.reconnects;
  d.wake = wake.since(before.wake);
  d.bus = bus.since(before.bus);
  d.wire = wire.since(before.wire);
  d.slack = slack.since(before.slack);
  return d;
}

}  // namespace darwinop::runtime
