// How a process ended.
#pragma once

#include <string>

namespace darwinop::process {

struct Ending {
  int code = 0;  // exit code or signal number
  bool by_signal = false;

  [[nodiscard]] bool isNormal() const { return !by_signal && code == 0; }
  /// Exit status as in a shell: 128 + signal number.
  [[nodiscard]] int shellStatus() const { return by_signal ? 128 + code : code; }
};

/// "with exit code 3", "by signal 11 (Segmentation fault)".
std::string describe(const Ending& ending);

}  // namespace darwinop::process
