// Holds the robot after the default controller has failed.
#include "supervisor/holder.hpp"

#include <memory>

#include "runtime/daemon_link.hpp"
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
    const bool holds = joint.driven || (joint.polled.ever() && joint.torque_enabled);
    if (!holds) commands.joint[i].setTorque(false);
  }
  return commands;
}

Holder::Holder(const runtime::RuntimeFiles& files)
    : session_{std::make_unique<runtime::DaemonLink>(files)}, commands_{asItIs(session_.sensors())} {
  session_.start();
  session_.publish(commands_);
}

bool Holder::hold() {
  const Sensors seen = session_.sensors();
  why_ended_ = session_.loopEnd(seen);
  if (!why_ended_.empty()) return false;
  if (const Fault fault = safety::latchedFault(seen.safety.active); fault != Fault::kNone) {
    why_ended_ = row(fault).meaning;
    return false;
  }
  session_.publish(commands_);
  return true;
}

}  // namespace darwinop::supervisor
