// The programs as a user starts them in a terminal.
#pragma once

#include <string>

#include "support/shell.hpp"
#include "system/rig.hpp"

namespace darwinop {

struct CommandLine : Rig {
  /// `darwinop-NAME ARGUMENTS` in the test's folder, at the end of its input.
  [[nodiscard]] Outcome call(const std::string& arguments) const {
    return shell("cd " + folder_.string() + " && " DARWINOP_BIN "/darwinop-" + arguments + " </dev/null");
  }
};

}  // namespace darwinop
