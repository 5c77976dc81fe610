// Parses a program's arguments, with one exit code for mistakes in them.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exit_codes.hpp"

namespace darwinop::app {

/// "no command 'rnu'; there are list, show, run, plot" where a command of `app` is missing and `words` are left: CLI11
/// reports that it is missing, not the word in its place. Else nothing.
inline std::optional<std::string> unknownCommand(const CLI::App& app, const std::vector<std::string>& words) {
  const auto word = std::ranges::find_if(words, [](const std::string& one) { return !one.starts_with('-'); });
  if (app.get_require_subcommand_min() == 0 || !app.get_subcommands().empty() || word == words.end())
    return std::nullopt;
  std::string names;
  for (const CLI::App* const one : app.get_subcommands([](const CLI::App* any) { return !any->get_group().empty(); }))
    names += (names.empty() ? "" : ", ") + one->get_name();
  return "no command '" + *word + "'; there are " + names;
}

/// "darwinop motion: PAGE: Value x not in range; see darwinop motion play --help".
inline std::string usageError(const CLI::App* app, const CLI::Error& mistake) {
  std::string command = app->get_name();
  const CLI::App* at = app;
  while (!at->get_subcommands().empty()) {
    at = at->get_subcommands().front();
    command += " " + at->get_name();
  }
  const std::string what = unknownCommand(*at, app->remaining(true)).value_or(mistake.what());
  return app->get_name() + ": " + what + "; see " + command + " --help\n";
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
