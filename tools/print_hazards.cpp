// Prints docs/hazards.md from the hazard table and the results of its tests.
//
//   print_hazards --programs               test programs that the table names, and the filter of each
//   print_hazards RESULTS                  the page; RESULTS holds PROGRAM.json of each program (--gtest_output)
//
// Exit code 1 with one line for each test of the table that does not exist or failed; one that was skipped is named.
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
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

std::map<std::string, std::string> filters() {
  std::map<std::string, std::string> filters;
  for (const Hazard& hazard : kHazards)
    for (const TestId& test : testsOf(hazard)) {
      std::string& filter = filters[test.program];
      filter += (filter.empty() ? "" : ":") + test.name;
    }
  return filters;
}

struct Outcome {
  bool passed = false;
  std::string cycles;  // empty: the test measures none
};

/// Of each test that ran, by "program:Suite.Test".
std::map<std::string, Outcome> readOutcomes(const std::string& folder) {
  std::map<std::string, Outcome> outcomes;
  for (const auto& [program, filter] : filters()) {
    std::ifstream file{folder + "/" + program + ".json"};
    if (!file) throw std::runtime_error("cannot read " + folder + "/" + program + ".json; run tools/check_hazards.sh");
    const nlohmann::json results = nlohmann::json::parse(file);
    for (const auto& suite : results.at("testsuites"))
      for (const auto& test : suite.at("testsuite")) {
        const std::string name = suite.at("name").get<std::string>() + "." + test.at("name").get<std::string>();
        Outcome& outcome = outcomes[program + ":" + name];
        const bool skipped = test.at("result") == "SKIPPED";  // says why by itself: it needs rights that are not there
        if (skipped) std::cerr << program << ' ' << name << " was skipped here\n";
        outcome.passed = skipped || (test.at("result") == "COMPLETED" && !test.contains("failures"));
        outcome.cycles = test.value("cycles", "");
      }
  }
  return outcomes;
}

std::string inMs(const std::string& cycles) {
  return std::to_string(16 * std::stol(cycles));
}

/// False when a test of the table is missing or has failed; says which.
bool complete(const std::map<std::string, Outcome>& outcomes) {
  bool all = true;
  for (const Hazard& hazard : kHazards)
    for (const TestId& test : testsOf(hazard)) {
      const auto found = outcomes.find(test.program + ":" + test.name);
      if (found != outcomes.end() && found->second.passed) continue;
      std::cerr << hazard.id << ": " << test.program << " " << test.name
                << (found == outcomes.end() ? " does not exist" : " does not pass") << '\n';
      all = false;
    }
  return all;
}

void print(std::ostream& out, const std::map<std::string, Outcome>& outcomes) {
  out << "# Hazards\n\n"
         "What can hurt a person or damage the robot, what must hold all the same, and the tests that show it. Made "
         "by\n"
         "`./dev docs` from `tests/hazards/hazard_table.hpp`; `./dev test docs` runs every test named here.\n\n"
         "Time: measured on the virtual robot from the cause to the reaction, at 16 ms a cycle. Without a time the "
         "constraint\n"
         "holds at every moment, or at start-up. Nothing here has run on a physical robot.\n\n"
         "| Id | Hazard | Cause | Constraint | Reaction | Time, ms | Tests |\n|---|---|---|---|---|---:|---|\n";
  for (const Hazard& hazard : kHazards) {
    std::string times, names;
    for (const TestId& test : testsOf(hazard)) {
      const std::string& measured = outcomes.at(test.program + ":" + test.name).cycles;
      if (!measured.empty()) times += (times.empty() ? "" : ", ") + inMs(measured);
      names += (names.empty() ? "`" : "<br>`") + test.name + "`";
    }
    out << "| " << hazard.id << " | " << hazard.hazard << " | " << hazard.cause << " | " << hazard.constraint << " | "
        << hazard.reaction << " | " << times << " | " << names << " |\n";
  }
}

int run(const std::vector<std::string>& arguments) {
  if (arguments == std::vector<std::string>{"--programs"}) {
    for (const auto& [program, filter] : filters()) std::cout << program << ' ' << filter << '\n';
    return 0;
  }
  if (arguments.size() != 1) throw std::runtime_error("give --programs or RESULTS");
  const auto outcomes = readOutcomes(arguments.front());
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
