// Holds the robot after the default controller has failed.
#include "supervisor/holder.hpp"

#include <atomic>

#include "safety/fault_book.hpp"

namespace darwinop::supervisor {

LedCommand redLights() {
  LedCommand led;
  led.setPanel(1);
  led.setHead(0x1F);
  return led;
}

Commands asItIs(const Sensors& seen) {
  Commands commands;
  commands.start_where_it_is = commands.unattended = true;
  commands.led = redLights();
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    const bool holds = joint.driven || (joint.health.ever() && joint.torque_enabled);
    if (!holds) commands.joint[i].setTorque(false);
  }
  return commands;
}

Holder::Holder(const runtime::RuntimeFiles& files) : link_{files}, commands_{asItIs(link_.sensors())} {
  link_.publish(commands_);
}

bool Holder::hold() {
  const std::atomic<bool> go_on{false};
  const Sensors seen = link_.sensors();
  if (!link_.waitForCycle(seen.cycle, go_on)) {  // a past cycle, so this does not block
    why_ended_ = link_.whyEnded();
    return false;
  }
  if (const Fault fault = safety::latchedFault(seen.safety.active); fault != Fault::kNone) {
    why_ended_ = row(fault).meaning;
    return false;
  }
  link_.publish(commands_);
  return true;
}

}  // namespace darwinop::supervisor
