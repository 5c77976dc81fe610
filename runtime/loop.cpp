// One step of the loop.
#include "runtime/loop.hpp"

namespace darwinop::runtime {
namespace {

/// Numbers of sessions wrap.
bool isLater(std::uint32_t session, std::uint32_t than) noexcept {
  return static_cast<std::int32_t>(session - than) > 0;
}

}  // namespace

Loop::Loop(ServoBus& bus, safety::Guard& guard, const Exchange& exchange, Recorder* recorder, Nanos period,
           LoopStats::Timed timed)
    : cycle_{bus, guard, period},
      exchange_{exchange},
      block_{exchange.ownBlock()},
      requests_{exchange.commands()},
      recorder_{recorder},
      timed_{timed},
      session_{block_.released.load()},
      released_{session_} {}

void Loop::turn(const CycleTime& time, std::uint32_t skipped) noexcept {
  (void)requests_.commands.read(newest_);  // no new image: the last one remains valid
  takeRequests();
  const Commands& asked = withOperator();
  cycle_.run(asked, time);
  const Sensors& sensors = cycle_.sensors();
  block_.stats.account(sensors, skipped, timed_);
  if (recorder_ != nullptr) recorder_->push(asked, sensors);
  publish(sensors);
}

/// Requests of an operator: `darwinop runtime --reset-faults` and `--release`.
void Loop::takeRequests() noexcept {
  if (isLater(newest_.session, session_)) session_ = newest_.session;
  if (requests_.fault_reset.isNew(resets_seen_)) ++fault_resets_;
  if (!requests_.release.isNew(releases_seen_)) return;
  driven_at_release_ = newest_.session;
  released_ = ++session_;
}

/// True for sessions that began before the last release. The one that drove at the release is compared by number: its
/// number is chosen by the client and may be any.
bool Loop::isRefused(std::uint32_t session) const noexcept {
  return released_ != 0 && (session == driven_at_release_ || !isLater(session, released_));
}

const Commands& Loop::withOperator() noexcept {
  // Safety ends the session that drove at the release; commands of older sessions are ignored.
  Commands& asked = newest_.session != 0 && isRefused(newest_.session) ? no_commands_ : newest_;
  asked.operator_releases = released_;
  asked.operator_resets = fault_resets_;
  // Without the exchange no commands arrive and no client can observe: bring the robot to rest.
  const bool closing = block_.closing.load(std::memory_order_relaxed) == ExchangeBlock::kClosing;
  asked.loop_ends = closing || exchange_.lost();
  if (asked.loop_ends) asked.end_of_session = true;
  return asked;
}

/// Writes every value in every cycle: this overwrites stray writes of other processes.
void Loop::publish(const Sensors& sensors) noexcept {
  block_.session.store(session_, std::memory_order_relaxed);
  block_.released.store(released_, std::memory_order_relaxed);
  block_.refused.store(isRefused(newest_.session) ? newest_.session : 0, std::memory_order_relaxed);
  requests_.instance.store(block_.instance, std::memory_order_relaxed);
  block_.sensors.publish(sensors);
  block_.finished.set(static_cast<std::uint32_t>(sensors.cycle), requests_.wait);
}

}  // namespace darwinop::runtime
