// Many cases: made, run blind, scored.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "core/json/json_text.hpp"
#include "gap/benchmark/body/body_suite.hpp"
#include "gap/benchmark/body/thesis_suite.hpp"
#include "gap/benchmark/make/own_suite.hpp"
#include "gap/benchmark/run/results.hpp"
#include "gap/benchmark/run/suite.hpp"
#include "gap/benchmark/score/body/body_case_table.hpp"
#include "gap/benchmark/score/body/body_score.hpp"
#include "gap/benchmark/score/score.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/parallel/ranks.hpp"
#include "gap_commands.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kBarWidth = 30;  // columns

/// "[######----] 12 of 32, about 5 min left"
std::string barOf(std::size_t done, std::size_t of, double elapsed_s) {
  const std::size_t full = of == 0 ? kBarWidth : kBarWidth * done / of;
  std::string bar = "[" + std::string(full, '#') + std::string(kBarWidth - full, '-') + "] " + std::to_string(done) +
                    " of " + std::to_string(of);
  if (done == 0 || done == of) return bar;
  const double left_s = elapsed_s * static_cast<double>(of - done) / static_cast<double>(done);
  return bar + ", about " +
         (left_s < 90 ? std::to_string(std::lround(left_s)) + " s"
                      : std::to_string(std::lround(left_s / 60)) + " min") +
         " left";
}

/// Lines that stay, and under them, on a terminal, a bar that is written over.
void show(const std::string& line, const std::string& bar) {
  static const bool terminal = isatty(STDERR_FILENO) == 1;
  std::string text = terminal ? "\r\033[K" : "";
  if (!line.empty()) text += "darwinop gap: " + line + "\n";
  std::cerr << (terminal ? text + bar : text) << std::flush;
}

template <class Part>
Part partCalled(const std::string& word) {
  constexpr std::array<std::string_view, 6> kWords{"quick", "singles", "effect-free", "pairs", "outside", "all"};
  const auto found = std::find(kWords.begin(), kWords.end(), word);
  if (found == kWords.end())
    throw std::runtime_error("there is no part '" + word +
                             "'; there are quick, singles, effect-free, pairs, outside, all");
  return static_cast<Part>(found - kWords.begin());
}

}  // namespace

int runBenchmark(const Arguments& given) {
  if (given.resume && given.out.empty()) throw std::runtime_error("--resume needs the results file: give --out");
  Suite suite;
  suite.folder = given.folder;
  suite.out = given.out;
  suite.resume = given.resume;
  suite.jobs = std::max<std::size_t>(1, given.jobs);
  const unsigned threads = given.threads == 0 ? Ranks::cores() : given.threads;
  setThreads(std::max(1U, threads / static_cast<unsigned>(suite.jobs)));
  suite.begun = [](std::size_t kept) {
    show(kept == 0 ? "" : std::to_string(kept) + " cases have a result already", "");
  };
  suite.progress = [](const SuiteProgress& progress) {
    show(lineOf(progress.answer), barOf(progress.done, progress.of, progress.elapsed_s));
  };
  const nlohmann::json answers = runSuite(suite);
  if (!Ranks::isFirst()) return 0;
  if (given.out.empty()) std::cout << jsonText(answers, 1) << '\n';
  const std::size_t errors = errorsIn(answers);
  show(std::to_string(answers.size()) + " cases" + (given.out.empty() ? "" : ", results in " + given.out), "");
  if (errors == 0) return 0;
  show(std::to_string(errors) + " of them failed with an internal error; see `why` in the results", "");
  return 1;
}

int makeBenchmark(const Arguments& given) {
  const auto make = [&given](auto requests, const auto& write) {
    if (given.cases > 0) requests.resize(std::min<std::size_t>(given.cases, requests.size()));
    std::cerr << "darwinop gap: seed " << given.seed << ", " << requests.size() << " cases\n";
    write(given.out, requests, [](std::size_t done, std::size_t of) {
      show(done == of || done % 20 == 0 ? std::to_string(done) + " of " + std::to_string(of) + " cases are made" : "",
           "");
    });
    return 0;
  };
  if (given.family == "thesis") return make(thesisRequests(given.seed), makeBodyCases);
  if (given.family != "body") return make(ownRequests(given.seed, partCalled<Part>(given.part)), makeCases);
  return make(given.effects.empty() ? bodyRequests(given.seed, partCalled<BodyPart>(given.part))
                                    : bodyRequestsFor(given.seed, given.effects),
              makeBodyCases);
}

int scoreBenchmark(const Arguments& given) {
  if (given.table) {
    if (!isBodyKey(given.key)) throw std::runtime_error("--table is for cases of the whole robot; leave it out");
    std::cout << bodyCaseTable(readBodyKeys(given.key), readBodyAnswers(given.results));
    return 0;
  }
  const Score score = isBodyKey(given.key) ? bodyScoreOf(readBodyKeys(given.key), readBodyAnswers(given.results))
                                           : scoreOf(readKeys(given.key), readAnswers(given.results));
  std::cout << (given.json ? asJson(score).dump(1) + "\n" : asText(score));
  if (!isBelow(score, given.at_least)) return 0;
  show(std::to_string(score.fair.right) + " of " + std::to_string(score.fair.of) +
           " answers are fair; the upper 95 % confidence bound is below the required " +
           std::to_string(std::lround(100 * given.at_least)) + " %",
       "");
  return 1;
}

}  // namespace darwinop::gap
