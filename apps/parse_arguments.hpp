// Parses a program's arguments, with one exit code for mistakes in them.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>

#include "exit_codes.hpp"

namespace darwinop::app {

/// "darwinop motion: PAGE: Value x not in range; see darwinop motion play --help".
inline std::string usageError(const CLI::App* app, const CLI::Error& mistake) {
  std::string command = app->get_name();
  for (const CLI::App* at = app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    command += " " + at->get_name();
  }
  return app->get_name() + ": " + mistake.what() + "; see " + command + " --help\n";
}

/// As CLI::App::parse(). Nothing: go on. Otherwise the program ends with this code: help or version was printed (0), or
/// a mistake (kWrong).
template <class... Arguments>
std::optional<int> parseArguments(CLI::App& app, Arguments&&... arguments) {
  app.failure_message(usageError);
  try {
    app.parse(std::forward<Arguments>(arguments)...);
    return std::nullopt;
  } catch (const CLI::ParseError& mistake) {
    return app.exit(mistake) == 0 ? 0 : kWrong;
  }
}

}  // namespace darwinop::app
