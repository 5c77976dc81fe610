// A virtual robot in this process, in simulated time: board, body, line and bus, all in memory.
#pragma once

#include <memory>

#include "hal/body.hpp"
#include "runtime/lockstep_link.hpp"

namespace darwinop::connect {

/// The same bus code as on a robot, so the same bytes; only the wire is memory. Repeatable to the bit. Without a body
/// the joints are plain motors. `config.port` names the robot in recordings.
std::unique_ptr<runtime::RobotLink> lockstepRobot(const runtime::LoopConfig& config,
                                                  std::unique_ptr<Body> body = nullptr);

}  // namespace darwinop::connect
