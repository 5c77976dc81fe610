// Suites of cases: generate, run without key, score.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "gap/battery/battery.hpp"
#include "gap/battery/results.hpp"
#include "gap/hide/own_battery.hpp"
#include "gap/hide/score.hpp"
#include "gap/sim/parallel.hpp"
#include "gap/sim/ranks.hpp"
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

/// Permanent lines and, on a terminal, a progress bar below them.
void show(const std::string& line, const std::string& bar) {
  static const bool terminal = isatty(STDERR_FILENO) == 1;
  std::string text = terminal ? "\r\033[K" : "";
  if (!line.empty()) text += "darwinop gap: " + line + "\n";
  std::cerr << (terminal ? text + bar : text) << std::flush;
}

Part partCalled(const std::string& word) {
  constexpr std::array<std::string_view, 6> kWords{"quick", "singles", "effect-free", "pairs", "outside", "all"};
  const auto found = std::find(kWords.begin(), kWords.end(), word);
  if (found == kWords.end())
    throw std::runtime_error("unknown part '" + word +
                             "'; expected quick, singles, effect-free, pairs, outside or all");
  return static_cast<Part>(found - kWords.begin());
}

}  // namespace

int runBattery(const Arguments& given) {
  if (given.resume && given.out.empty())
    throw std::runtime_error("--resume requires a results file; specify it with --out");
  Battery battery;
  battery.folder = given.folder;
  battery.out = given.out;
  battery.resume = given.resume;
  battery.jobs = std::max<std::size_t>(1, given.jobs);
  const unsigned threads = given.threads == 0 ? Ranks::cores() : given.threads;
  setThreads(std::max(1U, threads / static_cast<unsigned>(battery.jobs)));
  battery.begun = [](std::size_t kept) {
    show(kept == 0 ? "" : std::to_string(kept) + " cases already have a result", "");
  };
  battery.tell = [](const BatteryProgress& progress) {
    show(lineOf(progress.answer), barOf(progress.done, progress.of, progress.elapsed_s));
  };
  const nlohmann::json answers = answersOf(battery);
  if (!Ranks::isFirst()) return 0;
  if (given.out.empty()) std::cout << textOf(answers) << '\n';
  const std::size_t errors = errorsIn(answers);
  show(std::to_string(answers.size()) + " cases" + (given.out.empty() ? "" : ", results in " + given.out), "");
  if (errors == 0) return 0;
  show(std::to_string(errors) + " of them failed by a program error; see `why` in the results", "");
  return 1;
}

int writeBattery(const Arguments& given) {
  std::vector<HideRequest> requests = ownRequests(given.seed, partCalled(given.part));
  if (given.cases > 0) requests.resize(std::min<std::size_t>(given.cases, requests.size()));
  std::cerr << "darwinop gap: seed " << given.seed << ", " << requests.size() << " cases\n";
  makeCases(given.out, requests, [](std::size_t done, std::size_t of) {
    show(done == of || done % 20 == 0 ? std::to_string(done) + " of " + std::to_string(of) + " cases generated" : "",
         "");
  });
  return 0;
}

int scoreResults(const Arguments& given) {
  const Score score = scoreOf(readKeys(given.key), readAnswers(given.results));
  std::cout << (given.json ? asJson(score).dump(1) + "\n" : asText(score));
  if (!isBelow(score, given.at_least)) return 0;
  show(std::to_string(score.fair.right) + " of " + std::to_string(score.fair.of) +
           " cases are answered fairly: too few for a fair-answer rate of " +
           std::to_string(std::lround(100 * given.at_least)) + " %",
       "");
  return 1;
}

}  // namespace darwinop::gap
