// What the supervisor starts its children with.
#pragma once

#include <string>
#include <vector>

#include "hal/process/start.hpp"

namespace darwinop::supervisor {

/// In its own process group, so that Ctrl-C in a terminal reaches only the supervisor, and without real-time priority.
/// `log`: both outputs are appended here; empty: the supervisor's outputs.
inline process::Start childStart(std::vector<std::string> command, const std::string& log = "") {
  using process::Stream;
  const Stream output = log.empty() ? Stream{} : Stream::appendedTo(log);
  return {.command = std::move(command),
          .streams = {Stream::nothing(), output, output},
          .group = process::Start::Group::kItsOwn,
          .ends_with_us = true,
          .error_prefix = "darwinop supervisor: ",
          .ordinary_priority = true};
}

}  // namespace darwinop::supervisor
