// Parses a program's arguments, with one exit code for mistakes in them.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <utility>

namespace darwinop::app {

inline constexpr int kWrongArguments = 2;

/// As CLI::App::parse(). Nothing: go on. Otherwise the program ends with this code: help or version was printed (0), or
/// a mistake (kWrongArguments).
template <class... Arguments>
std::optional<int> parseArguments(CLI::App& app, Arguments&&... arguments) {
  try {
    app.parse(std::forward<Arguments>(arguments)...);
    return std::nullopt;
  } catch (const CLI::ParseError& mistake) {
    return app.exit(mistake) == 0 ? 0 : kWrongArguments;
  }
}

}  // namespace darwinop::app
