#include "hal/process/ending.hpp"

#include <cstring>

namespace darwinop::process {

std::string describe(const Ending& ending) {
  if (!ending.by_signal) return "with exit code " + std::to_string(ending.code);
  return "by signal " + std::to_string(ending.code) + " (" + strsignal(ending.code) + ")";
}

}  // namespace darwinop::process
