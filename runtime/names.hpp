// Where the runtime's shared files are.
#pragma once

#include <string>

namespace darwinop::runtime {

/// The files of one daemon. Several may run on one machine under different names.
struct RuntimeFiles {
  /// `name` without a slash lies in /dev/shm, with one it is a path. Empty: $DARWINOP_RUNTIME_NAME, or else
  /// "darwinop-runtime".
  explicit RuntimeFiles(const std::string& name = "");

  std::string exchange;    // the memory
  std::string loop_lock;   // held as long as the loop lives
  std::string drive_lock;  // held by the one controller that drives
  // What its camera sees, for onlookers, and when they asked for it last: hal/shared_picture/layout.hpp.
  std::string pictures, pictures_asked;
};

}  // namespace darwinop::runtime
