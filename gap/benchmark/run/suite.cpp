#include "gap/benchmark/run/suite.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "core/json/json_text.hpp"
#include "gap/benchmark/run/cases.hpp"
#include "gap/benchmark/run/results.hpp"
#include "gap/parallel/ranks.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

constexpr auto kPollPeriod = 5ms;            // of messages from other ranks
constexpr const char* kRequest = "request";  // a rank is ready for a case
constexpr const char* kDone = "done";        // no case is left
constexpr const char* kCase = "case ";       // followed by its name

json answerWithHash(const Suite& suite, const CaseFolder& one) {
  json answer = suite.answer(one.path);
  answer["case_hash"] = one.fingerprint;
  return answer;
}

/// The first rank: distributes the cases to its own threads and to the other ranks, and collects the results.
class Coordinator {
 public:
  Coordinator(const Suite& suite, const std::vector<CaseFolder>& cases, Results& results)
      : suite_{suite}, cases_{cases}, results_{results} {}

  void run() {
    std::vector<std::future<void>> own;
    for (std::size_t i = 0; i < std::min(suite_.jobs, cases_.size()); ++i)
      own.push_back(std::async(std::launch::async, [this] { work(); }));
    // This thread serves the other ranks; a case runs in a thread of its own, so that its loops use no other rank.
    for (int ranks = Ranks::count() - 1; ranks > 0;) {
      if (const auto message = received())
        ranks -= serve(*message) ? 0 : 1;
      else
        std::this_thread::sleep_for(kPollPeriod);
    }
    for (auto& one : own) one.get();
  }

 private:
  void work() {
    for (std::size_t i = 0; (i = next_++) < cases_.size();) take(answerWithHash(suite_, cases_[i]));
  }

  /// False: no case is left, and that rank ends.
  bool serve(const Message& message) {
    if (message.text != kRequest) {
      take(json::parse(message.text));
      return true;
    }
    const std::size_t i = next_++;
    sendTo(message.from, i < cases_.size() ? kCase + cases_[i].name : kDone);
    return i < cases_.size();
  }

  void take(const json& answer) {
    const std::lock_guard lock{taking_};
    ++done_;
    results_.put(answer);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    suite_.progress({.done = done_, .of = cases_.size(), .answer = answer, .elapsed_s = elapsed.count()});
  }

  const Suite& suite_;
  const std::vector<CaseFolder>& cases_;
  Results& results_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::atomic<std::size_t> next_{0};
  std::mutex taking_;
  std::size_t done_ = 0;
};

Message nextMessage() {
  while (true) {
    if (auto message = received()) return *message;
    std::this_thread::sleep_for(kPollPeriod);  // MPI's own waiting keeps a core busy
  }
}

/// The other ranks: a case at a time until there are no more.
void workForFirstRank(const Suite& suite) {
  // All cases; the first rank names those that are left.
  const std::vector<CaseFolder> cases = casesIn(suite.folder);
  while (true) {
    sendTo(0, kRequest);
    const Message message = nextMessage();
    const std::string& text = message.text;
    if (text == kDone) return;
    const auto one = std::ranges::find(cases, text.substr(std::string_view{kCase}.size()), &CaseFolder::name);
    if (one == cases.end())
      throw std::runtime_error(suite.folder + ": rank " + std::to_string(Ranks::own()) + " does not have " + text +
                               " there; all ranks need the same files");
    auto answer = std::async(std::launch::async, [&] { return answerWithHash(suite, *one); });
    sendTo(0, jsonText(answer.get()));
  }
}

}  // namespace

json runSuite(const Suite& suite) {
  if (Ranks::count() > 1 && suite.jobs > 1)
    throw std::runtime_error("--jobs is for one process; under mpirun -n N each of the N has one case at a time");
  if (!Ranks::isFirst()) {
    workForFirstRank(suite);
    return json::array();
  }
  std::vector<CaseFolder> cases = casesIn(suite.folder);
  Results results{suite.out, suite.resume};
  std::map<std::string, std::string> fingerprints;
  for (const CaseFolder& one : cases) fingerprints[one.name] = one.fingerprint;
  results.keepOnly(fingerprints);
  std::erase_if(cases, [&](const CaseFolder& one) { return results.has(one.name, one.fingerprint); });
  suite.begun(results.count());
  Coordinator{suite, cases, results}.run();
  return results.all();
}

std::size_t errorsIn(const json& answers) {
  return static_cast<std::size_t>(
      std::ranges::count_if(answers, [](const json& answer) { return answer.at("verdict") == "error"; }));
}

}  // namespace darwinop::gap
