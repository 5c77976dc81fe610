// Paths of the runtime's shared files.
#pragma once

#include <string>

namespace darwinop::runtime {

/// Environment variable; 1: a program, not a person, started this process. Its sessions do not clear latched faults.
inline constexpr const char* kUnattended = "DARWINOP_UNATTENDED";
[[nodiscard]] bool startedUnattended();

/// Files of one daemon. Several daemons can run on one machine under different names.
struct RuntimeFiles {
  /// `name`: a path, or without a slash a file in /dev/shm. Empty: $DARWINOP_RUNTIME_NAME, else "darwinop-runtime".
  explicit RuntimeFiles(const std::string& name = "");

  std::string exchange;    // output of the loop: written by the runtime only
  std::string commands;    // input of the loop: written by the runtime's group
  std::string loop_lock;   // locked while the loop runs
  std::string drive_lock;  // driving lease: locked by the controller that drives
  std::string released;  // 1 from a release by a person until a person acts, else 0; survives the daemon, not a reboot
  std::string held;      // 1 while joints are held, else 0; survives the daemon, not a reboot
  // Camera pictures for observers, and the time of their last request: hal/shared_picture/layout.hpp.
  std::string pictures, pictures_asked;
};

}  // namespace darwinop::runtime
