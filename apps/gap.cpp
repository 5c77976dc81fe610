// darwinop-gap: locates where logs and model diverge, and identifies what is missing from the model.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>

#include "exit_codes.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/parallel/ranks.hpp"
#include "gap_options.hpp"
#include "parse_arguments.hpp"

namespace {

namespace gap = darwinop::gap;

/// Under mpirun, what one rank does alone is for the first.
bool isShared(gap::Command command) {
  return command == gap::run || command == gap::runBenchmark;
}

/// Options before the name of a command, moved behind everything else: they count the same there. In CLI11's order,
/// last first.
std::vector<std::string> inOrder(const CLI::App& app, int count, char** arguments) {
  std::vector<std::string> words(arguments + 1, arguments + count);
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  const auto name = std::ranges::find_first_of(words, commands, {}, {}, &CLI::App::get_name);
  if (name != words.end()) std::rotate(words.begin(), name, words.end());  // clang++ 14 has no ranges::rotate for it
  std::ranges::reverse(words);
  return words;
}

int command(int count, char** arguments) {
  gap::Arguments given;
  CLI::App app{
      "Locates where logs and model diverge, identifies the missing effect, adds it to the model.\n\n"
      "Exit code of run: 0 nothing is missing, 10 named, 11 ambiguous, 12 unknown, 13 cannot tell, 2 bad input, "
      "1 a failure after that.",
      "darwinop gap"};
  app.require_subcommand(1);
  app.fallthrough();  // --threads behind the command
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.add_option("--threads", given.threads, "threads to use; else one a core");
  const std::vector<gap::ParsedCommand> rows = gap::addCommands(app, given);
  app.footer("Example:\n  darwinop gap run tests/gap/cases/example --out repaired.ini");
  if (const auto code = darwinop::app::parseArguments(app, inOrder(app, count, arguments))) return *code;
  gap::setThreads(given.threads == 0 ? gap::Ranks::cores() : given.threads);
  for (const gap::ParsedCommand& row : rows)
    if (row.parsed->parsed()) return gap::Ranks::isFirst() || isShared(row.command) ? row.command(given) : 0;
  return 2;
}

int failed(const std::exception& error, int code) {
  std::cerr.clear();
  std::cerr << "darwinop gap: " << error.what() << '\n';
  return gap::Ranks::giveUp(code);
}

}  // namespace

int main(int count, char** arguments) {
  const gap::Ranks ranks;
  if (!gap::Ranks::isFirst())
    for (std::ostream* const out : {&std::cout, &std::cerr}) out->setstate(std::ios::badbit);  // one result for all
  try {
    const int code = command(count, arguments);
    std::cout.flush();
    return gap::Ranks::isFirst() ? code : 0;
  } catch (const gap::NotDelivered& error) {
    return failed(error, darwinop::app::kFailed);
  } catch (const std::exception& error) {
    return failed(error, darwinop::app::kWrong);
  }
}
