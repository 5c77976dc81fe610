// One turn of the loop.
#include "runtime/loop.hpp"

namespace darwinop::runtime {

Loop::Loop(ServoBus& bus, safety::Guard& guard, ExchangeBlock& block, Recorder* recorder, Nanos period,
           LoopStats::Timed timed)
    : cycle_{bus, guard, period}, block_{block}, recorder_{recorder}, timed_{timed} {}

void Loop::turn(const CycleTime& time, std::uint32_t skipped) noexcept {
  (void)block_.commands.read(newest_);  // nothing new: the last image stays in force
  const Commands asked = withOperator(newest_);
  cycle_.run(asked, time);
  const Sensors& sensors = cycle_.sensors();
  block_.sensors.publish(sensors);
  block_.stats.account(sensors, skipped, timed_);
  if (recorder_ != nullptr) recorder_->push(asked, sensors);
  block_.finished.advance();
}

/// What an operator asked for beside the controller: `darwinop runtime --reset-faults` and `--release`.
Commands Loop::withOperator(Commands asked) noexcept {
  const std::uint32_t released = block_.released.load(std::memory_order_relaxed);
  // A release is a session of its own that wishes every joint limp. So it holds whether the controller steps, stalls
  // or is gone, until a controller with a session after it takes over.
  if (released != 0 && static_cast<std::int32_t>(released - asked.session) > 0) {
    asked = Commands{};
    asked.session = released;
    asked.sequence = ++release_ticks_;
    asked.start_where_it_is = true;
    for (JointCommand& joint : asked.joint) joint.setTorque(false);
  }
  asked.fault_resets += block_.fault_resets.load(std::memory_order_relaxed);
  if (block_.closing.load(std::memory_order_relaxed) != 0) asked.farewell = true;
  return asked;
}

}  // namespace darwinop::runtime
