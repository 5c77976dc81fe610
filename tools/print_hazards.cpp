// Prints docs/hazards.md from the hazard table and the results of its tests.
//
//   print_hazards --tests       CTest names of the tests that the table names: that of the program, and its own
//   print_hazards <RESULTS      the page; RESULTS are lines of tools/print_test_results.py
//
// Exit code 1 with one line for each test of the table that does not exist, failed or was skipped, and for each row
// that neither has a measured time nor says why not.
#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "hazards/hazard_table.hpp"

namespace {

using darwinop::Hazard;
using darwinop::kHazards;

struct TestId {
  std::string program, name;  // "safety_test", "Kneel.TheButtonReleasesAllJoints"
};

std::vector<TestId> testsOf(const Hazard& hazard) {
  std::vector<TestId> tests;
  std::istringstream words{std::string{hazard.tests}};
  for (std::string word; words >> word;) {
    const auto colon = word.find(':');
    if (colon == word.npos) throw std::runtime_error(std::string{hazard.id} + ": no program before '" + word + "'");
    tests.push_back({word.substr(0, colon), word.substr(colon + 1)});
  }
  if (tests.empty()) throw std::runtime_error(std::string{hazard.id} + " has no test");
  return tests;
}

struct Outcome {
  bool passed = false, skipped = false;
  std::string cycles;  // empty: the test measures none
};

/// Of each test that ran, by "program:Suite.Test".
std::map<std::string, Outcome> readOutcomes(std::istream& results) {
  std::map<std::string, Outcome> outcomes;
  for (std::string line; std::getline(results, line);) {
    std::istringstream fields{line};
    std::string program, name, result, cycles;
    fields >> program >> name >> result >> cycles;  // without a measured time, cycles stays empty
    outcomes[program + ":" + name] = {result == "passed", result == "skipped", cycles};
  }
  return outcomes;
}

std::string inMs(long cycles) {
  return std::to_string(16 * cycles);
}

/// Cycles that the tests of a hazard measured.
std::vector<long> cyclesOf(const Hazard& hazard, const std::map<std::string, Outcome>& outcomes) {
  std::vector<long> cycles;
  for (const TestId& test : testsOf(hazard)) {
    const auto found = outcomes.find(test.program + ":" + test.name);
    if (found != outcomes.end() && !found->second.cycles.empty()) cycles.push_back(std::stol(found->second.cycles));
  }
  return cycles;
}

/// A hazard has a measured time, which is more than none, or a word that says why not.
bool timed(const Hazard& hazard, const std::map<std::string, Outcome>& outcomes) {
  const std::vector<long> cycles = cyclesOf(hazard, outcomes);
  const bool real = std::ranges::all_of(cycles, [](long count) { return count > 0; });
  if (real && cycles.empty() != hazard.untimed.empty()) return true;
  std::cerr << hazard.id
            << (cycles.empty() ? " has no measured time and does not say why"
                : real         ? " has a measured time and says that it has none"
                               : " was measured as 0 cycles: its reaction was there before its cause")
            << '\n';
  return false;
}

/// False when a test of the table is missing, has failed or did not run; says which.
bool complete(const std::map<std::string, Outcome>& outcomes) {
  bool all = true;
  for (const Hazard& hazard : kHazards)
    for (const TestId& test : testsOf(hazard)) {
      const auto found = outcomes.find(test.program + ":" + test.name);
      if (found != outcomes.end() && found->second.passed) continue;
      std::cerr << hazard.id << ": " << test.program << " " << test.name
                << (found == outcomes.end() ? " does not exist"
                    : found->second.skipped ? " was skipped, so nothing shows this row; run it as root"
                                            : " does not pass")
                << '\n';
      all = false;
    }
  for (const Hazard& hazard : kHazards) all = timed(hazard, outcomes) && all;
  return all;
}

void print(std::ostream& out, const std::map<std::string, Outcome>& outcomes) {
  out << "# Hazards\n\n"
         "What can hurt a person or damage the robot, what must hold all the same, and the tests that show it. Made "
         "by\n"
         "`./dev docs` from `tests/hazards/hazard_table.hpp`; `./dev test asan` runs every test named here.\n\n"
         "Time: measured on the virtual robot from the cause to the reaction, at 16 ms a cycle; the longest of "
         "a row.\n"
         "`always`: the cause has no effect in any cycle. `start-up`, `process`, `signal`, `access`: outside of the "
         "cycle. Nothing here\n"
         "has run on a physical robot.\n\n"
         "Id|Hazard|Cause|Constraint|Reaction|Time, ms|Tests\n---|---|---|---|---|---:|---\n";
  for (const Hazard& hazard : kHazards) {
    std::string names;
    for (const TestId& test : testsOf(hazard)) names += (names.empty() ? "`" : "<br>`") + test.name + "`";
    const std::vector<long> cycles = cyclesOf(hazard, outcomes);
    const std::string time = cycles.empty() ? std::string{hazard.untimed} : inMs(std::ranges::max(cycles));
    out << hazard.id << '|' << hazard.hazard << '|' << hazard.cause << '|' << hazard.constraint << '|'
        << hazard.reaction << '|' << time << '|' << names << '\n';
  }
}

int run(const std::vector<std::string>& arguments) {
  if (arguments == std::vector<std::string>{"--tests"}) {
    for (const Hazard& hazard : kHazards)
      for (const TestId& test : testsOf(hazard)) std::cout << test.program << '\n' << test.name << '\n';
    return 0;
  }
  if (!arguments.empty()) throw std::runtime_error("give --tests, or results on standard input");
  const auto outcomes = readOutcomes(std::cin);
  if (!complete(outcomes)) return 1;
  print(std::cout, outcomes);
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  return run({arguments + 1, arguments + count});
} catch (const std::exception& error) {
  std::cerr << "print_hazards: " << error.what() << '\n';
  return 1;
}
