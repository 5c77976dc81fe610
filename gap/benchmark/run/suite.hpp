// Runs a suite of cases blind: only case.json and the logs it names are opened, never an answer key.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "gap/benchmark/run/answer.hpp"

namespace darwinop::gap {

/// After each case.
struct SuiteProgress {
  std::size_t done = 0, of = 0;  // of those that had to be run
  const nlohmann::json& answer;
  double elapsed_s = 0;
};

struct Suite {
  std::string folder;    // of cases; one that has `cases` in it does as well
  std::string out;       // results.json; empty: nothing is written
  bool resume = false;   // keep the results that `out` has
  std::size_t jobs = 1;  // cases at once; under mpirun each rank has one
  std::function<nlohmann::json(const std::string& folder)> answer = answerFor;
  std::function<void(std::size_t kept)> begun = [](std::size_t) {};  // with so many answers of an earlier run
  std::function<void(const SuiteProgress&)> progress = [](const SuiteProgress&) {};
};

/// All results, in the order of the names. Under mpirun every rank calls it; the first reports, writes and returns
/// them, the others return an empty list. Throws std::runtime_error, a sentence, when there is no case or no room for
/// results.
nlohmann::json runSuite(const Suite& suite);

/// Cases that ended with verdict `error`.
std::size_t errorsIn(const nlohmann::json& answers);

}  // namespace darwinop::gap
