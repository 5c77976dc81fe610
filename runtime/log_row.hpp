// One line of a recording.
#pragma once

#include "core/commands.hpp"
#include "core/sensors.hpp"

namespace darwinop::runtime {

struct LogRow {
  Commands asked;   // as the controller gave them, before safety
  Sensors sensors;  // after the cycle, what was sent included
};

}  // namespace darwinop::runtime
