// One row of a recording.
#pragma once

#include "core/commands.hpp"
#include "core/sensors.hpp"

namespace darwinop::runtime {

struct LogRow {
  Commands asked;   // the controller's, before safety
  Sensors sensors;  // after the cycle, including the goals sent
};

}  // namespace darwinop::runtime
