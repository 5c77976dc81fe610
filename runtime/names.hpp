// Where the runtime's shared files are.
#pragma once

#include <string>

namespace darwinop::runtime {

/// Environment variable, 1: a program started this process and no person did. Its sessions clear no latched fault.
inline constexpr const char* kUnattended = "DARWINOP_UNATTENDED";
[[nodiscard]] bool startedUnattended();

/// The files of one daemon. Several may run on one machine under different names.
struct RuntimeFiles {
  /// `name` without a slash lies in /dev/shm, with one it is a path. Empty: $DARWINOP_RUNTIME_NAME, or else
  /// "darwinop-runtime".
  explicit RuntimeFiles(const std::string& name = "");

  std::string exchange;    // output of the loop: written by the runtime alone
  std::string commands;    // what the loop is asked for: written by the runtime's group
  std::string loop_lock;   // held as long as the loop lives
  std::string drive_lock;  // held by the one controller that drives
  std::string released;    // exists while a person's release waits for a person; outlives the daemon, not the computer
  std::string held;        // exists while joints are held; the same
  // Camera pictures for observers, and the time of their last request: hal/shared_picture/layout.hpp.
  std::string pictures, pictures_asked;
};

}  // namespace darwinop::runtime
