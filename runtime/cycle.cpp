#include "runtime/cycle.hpp"

#include "runtime/merge.hpp"

namespace darwinop::runtime {

Cycle::Cycle(ServoBus& bus, safety::Guard& guard, Nanos period) : bus_{bus}, guard_{guard} {
  sensors_.period_ns = period.count();
}

void Cycle::run(const Commands& asked, const CycleTime& time) noexcept {
  const SafeCommands safe = guard_.vet(asked, sensors_);  // every command passes through the safety layer
  bus_.write(safe);                                       // one SyncWrite; in rare cases two
  bus_.read(readings_);                                   // one BulkRead
  noteCommanded(safe, sensors_);                          // adds the goals sent to the sensor image
  merge(readings_, sensors_);  // devices without a reply keep their values; their age increases
  account(time);
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
