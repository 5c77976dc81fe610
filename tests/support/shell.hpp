// A command line as a user types it: its exit status and its output.
#pragma once

#include <unistd.h>

#include <array>
#include <string>

#include "hal/process/child_process.hpp"

namespace darwinop {

struct Outcome {
  int status;  // 128 and more: the signal that ended it
  std::string said;
};

inline Outcome shell(const std::string& command) {
  using process::Stream;
  process::ChildProcess child{{.command = {"/bin/sh", "-c", command + " 2>&1"}, .streams = {{}, Stream::pipe()}}};
  std::string said;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; (count = read(child.stream(STDOUT_FILENO), part.data(), part.size())) > 0;)
    said.append(part.data(), static_cast<std::size_t>(count));
  return {child.wait().shellStatus(), said};
}

}  // namespace darwinop
