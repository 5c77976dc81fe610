// The commands and options of darwinop-gap, and their help.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "gap_commands.hpp"

namespace darwinop::gap {

using Command = int (*)(const Arguments&);

struct ParsedCommand {
  CLI::App* parsed;
  Command command;
};

/// Adds every command to `app`. Parsing it fills `given`, which has to outlive `app`.
std::vector<ParsedCommand> addCommands(CLI::App& app, Arguments& given);

}  // namespace darwinop::gap
