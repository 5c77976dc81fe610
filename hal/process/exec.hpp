// From fork to exec, in the child. Allocated before: between fork and exec of a process with threads only
// async-signal-safe calls are allowed.
#pragma once

#include <sys/types.h>

#include <array>
#include <string>
#include <vector>

#include "hal/process/start.hpp"

namespace darwinop::process {

struct Prepared {
  const Start& start;
  std::string program;  // path
  std::vector<std::string> environment;
  std::vector<char*> arguments, variables;          // with a null pointer at the end
  std::array<int, Start::kMaxStreams> descriptors;  // of pipes and copies: the child's end; else -1
  int failure;                                      // receives errno if exec fails; -1: see Start::error_prefix
  pid_t parent;
};

[[noreturn]] void execute(Prepared& with) noexcept;

}  // namespace darwinop::process
