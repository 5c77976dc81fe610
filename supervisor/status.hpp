// What the supervisor is doing, as a small file that anybody may read.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "runtime/names.hpp"

namespace darwinop::supervisor {

/// Where it is told. Beside the runtime's files, under the runtime's name.
struct SupervisorFiles {
  explicit SupervisorFiles(const runtime::RuntimeFiles& files)
      : lock{files.exchange + ".supervisor"}, status{files.exchange + ".supervised"} {}
  std::string lock;    // held as long as the supervisor lives
  std::string status;  // replaced at every change
};

struct Status {
  std::string home, state, controller;        // state: "driving: ...", a sentence; controller: its name
  pid_t runtime_pid = 0, controller_pid = 0;  // 0: does not run
  std::size_t crashes = 0;                    // of the controller, within the last minute
  std::uint32_t orders = 0;                   // carried out so far
  bool controller_ended = false;              // and will not be started by itself

  bool operator==(const Status&) const = default;
};

/// Replaces the file in one step. A full or read-only /dev/shm is no reason to stop: false.
bool writeStatus(const Status& status, const std::string& path);
/// Nothing when there is no file, or one that is not understood.
std::optional<Status> readStatus(const std::string& path);

}  // namespace darwinop::supervisor
