// Parses a program's arguments, with one exit code for mistakes in them.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <utility>

#include "exit_codes.hpp"

namespace darwinop::app {

/// As CLI::App::parse(). Nothing: go on. Otherwise the program ends with this code: help or version was printed (0), or
/// a mistake (kWrong).
template <class... Arguments>
std::optional<int> parseArguments(CLI::App& app, Arguments&&... arguments) {
  try {
    app.parse(std::forward<Arguments>(arguments)...);
    return std::nullopt;
  } catch (const CLI::ParseError& mistake) {
    return app.exit(mistake) == 0 ? 0 : kWrong;
  }
}

}  // namespace darwinop::app
