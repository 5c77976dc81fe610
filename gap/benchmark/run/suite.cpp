#include "gap/benchmark/run/suite.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "gap/benchmark/run/cases.hpp"
#include "gap/benchmark/run/results.hpp"
#include "gap/parallel/ranks.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

constexpr auto kGlance = 5ms;              // between two looks at what other ranks say
constexpr const char* kHungry = "hungry";  // a rank's word for: give me a case
constexpr const char* kEnough = "enough";  // the first rank's answer when there is none left
constexpr const char* kCase = "case ";     // before the name of one

json answerWithHash(const Suite& battery, const CaseFolder& one) {
  json answer = battery.answer(one.path);
  answer["case_hash"] = one.fingerprint;
  return answer;
}

/// The first rank: hands the cases out, to its own threads and to the other ranks, and collects the answers.
class Dealer {
 public:
  Dealer(const Suite& battery, const std::vector<CaseFolder>& cases, Results& results)
      : battery_{battery}, cases_{cases}, results_{results} {}

  void run() {
    std::vector<std::future<void>> own;
    for (std::size_t i = 0; i < std::min(battery_.jobs, cases_.size()); ++i)
      own.push_back(std::async(std::launch::async, [this] { work(); }));
    // This thread serves the others; work is for other threads, as they share no bootstrap with other ranks.
    for (int guests = Ranks::count() - 1; guests > 0;) {
      if (const auto message = received())
        guests -= serve(*message) ? 0 : 1;
      else
        std::this_thread::sleep_for(kGlance);
    }
    for (auto& one : own) one.get();
  }

 private:
  void work() {
    for (std::size_t i = 0; (i = next_++) < cases_.size();) take(answerWithHash(battery_, cases_[i]));
  }

  /// False: that rank has been sent home.
  bool serve(const Message& message) {
    if (message.text != kHungry) {
      take(json::parse(message.text));
      return true;
    }
    const std::size_t i = next_++;
    sendTo(message.from, i < cases_.size() ? kCase + cases_[i].name : kEnough);
    return i < cases_.size();
  }

  void take(const json& answer) {
    const std::lock_guard lock{taking_};
    ++done_;
    results_.put(answer);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    battery_.progress({.done = done_, .of = cases_.size(), .answer = answer, .elapsed_s = elapsed.count()});
  }

  const Suite& battery_;
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
    std::this_thread::sleep_for(kGlance);  // MPI's own waiting keeps a core busy
  }
}

/// The other ranks: a case at a time until there are no more.
void beGuest(const Suite& battery) {
  // The first rank knows which cases are left; these are all, in the same order.
  const std::vector<CaseFolder> cases = casesIn(battery.folder);
  while (true) {
    sendTo(0, kHungry);
    const std::string text = nextMessage().text;
    if (text == kEnough) return;
    const auto one = std::ranges::find(cases, text.substr(std::string_view{kCase}.size()), &CaseFolder::name);
    if (one == cases.end())
      throw std::runtime_error(battery.folder + ": rank " + std::to_string(Ranks::own()) + " sees no " + text +
                               " there; all ranks need the same files");
    auto answer = std::async(std::launch::async, [&] { return answerWithHash(battery, *one); });
    sendTo(0, textOf(answer.get(), -1));
  }
}

}  // namespace

json runSuite(const Suite& battery) {
  if (Ranks::count() > 1 && battery.jobs > 1)
    throw std::runtime_error("--jobs is for one process; under mpirun -n N each of the N has one case at a time");
  if (!Ranks::isFirst()) {
    beGuest(battery);
    return json::array();
  }
  std::vector<CaseFolder> cases = casesIn(battery.folder);
  Results results{battery.out, battery.resume};
  std::map<std::string, std::string> fingerprints;
  for (const CaseFolder& one : cases) fingerprints[one.name] = one.fingerprint;
  results.keepOnly(fingerprints);
  std::erase_if(cases, [&](const CaseFolder& one) { return results.has(one.name, one.fingerprint); });
  battery.begun(results.count());
  Dealer{battery, cases, results}.run();
  return results.all();
}

std::size_t errorsIn(const json& answers) {
  return static_cast<std::size_t>(
      std::ranges::count_if(answers, [](const json& answer) { return answer.at("verdict") == "error"; }));
}

}  // namespace darwinop::gap
