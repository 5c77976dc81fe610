// Status file of the supervisor, world-readable.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "runtime/names.hpp"

namespace darwinop::supervisor {

/// File names: beside the runtime's files, derived from the runtime's name.
struct SupervisorFiles {
  explicit SupervisorFiles(const runtime::RuntimeFiles& files)
      : lock{files.exchange + ".supervisor"}, status{files.exchange + ".supervised"} {}
  std::string lock;    // locked for the lifetime of the supervisor; the file remains
  std::string status;  // replaced at every change; the last one remains
};

struct Status {
  std::string home, state, controller;        // state: a message such as "driving: ..."; controller: its name
  pid_t runtime_pid = 0, controller_pid = 0;  // 0: does not run
  std::size_t crashes = 0;                    // of the controller, within the last minute
  std::uint32_t orders = 0;                   // completed so far
  std::string left;                           // at the end: sentence if joints may be under torque
  bool at_rest = false;                       // at the end: no joint is under torque
  bool stopping = false;                      // the stop command was given: no other starts anything
  bool stays_ended = false;       // at the end: the controller was not to run before the stop command either
  bool controller_ended = false;  // and will not be restarted automatically

  bool operator==(const Status&) const = default;
};

/// Replaces the file atomically. Returns false if /dev/shm is full or read-only, which is not fatal.
bool writeStatus(const Status& status, const std::string& path);
/// Empty if there is no file or it is invalid.
std::optional<Status> readStatus(const std::string& path);

}  // namespace darwinop::supervisor
