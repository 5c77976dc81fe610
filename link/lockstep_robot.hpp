// A virtual robot in this process, in simulated time: board, body, line and bus, all in memory.
#pragma once

#include <memory>

#include "runtime/lockstep_link.hpp"

namespace darwinop::link {

/// The same bus code as on a robot, so the same bytes; only the wire is memory. Repeatable to the bit.
std::unique_ptr<runtime::RobotLink> lockstepRobot(runtime::LoopConfig config);

}  // namespace darwinop::link
