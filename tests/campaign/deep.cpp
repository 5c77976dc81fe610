// The campaign for as long as one likes: shards with seeds of their own, one thread for each core, a line of progress.
// A shard that fails is reported at once, with the command that repeats it; the others go on.
//   campaign_deep [CYCLES] [SEED]
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/shard_seed.hpp"

namespace darwinop {
namespace {

constexpr long kShard = 100'000;   // cycles: a shard that fails is run again alone in seconds
constexpr int kMostFailures = 20;  // shards; more say nothing new
constexpr double kFaultsPerSecond = 2;

struct Totals {
  long cycles = 0, readings = 0, goals = 0;
  std::array<std::uint64_t, hil::kFaultKinds> faults{};
  ServoJudge::Tally tally;
  Tolerated tolerated;
};

class Deep {
 public:
  Deep(long cycles, std::uint64_t seed) : wanted_{cycles}, seed_{seed} {}

  int run() {
    std::printf("campaign of %ld cycles, seed %llu\n", wanted_, static_cast<unsigned long long>(seed_));
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
      threads.emplace_back([this] { work(); });
    threads.clear();
    report();
    return failed_ == 0 ? 0 : 1;
  }

 private:
  void work() {
    while (true) {
      const long shard = next_shard_++;
      if (shard * kShard >= wanted_ || failed_ >= kMostFailures) return;
      const std::uint64_t seed = shardSeed(seed_, static_cast<std::uint64_t>(shard));
      const bool board = shard % 3 != 2;
      Campaign campaign{seed, std::make_unique<FallingBody>(), board};
      // Every other shard keeps bytes whole: a reading is right or missing there, without exception.
      const bool whole = shard % 2 == 0;
      campaign.fight(std::min(kShard, wanted_ - shard * kShard), kFaultsPerSecond,
                     whole ? kindsThatKeepBytesWhole() : allKinds());
      std::string failure = campaign.failure();
      const double allowed = Campaign::wrongReadingsAllowed(whole, campaign.readings);
      if (failure.empty() && static_cast<double>(campaign.wrong) > allowed)
        failure = std::to_string(campaign.wrong) + " wrong readings passed for fresh";
      const std::string test = std::string{board ? "" : "*WithoutABoard"} + (whole ? "*Stale*" : "*Damaged*") +
                               (board ? "-*WithoutABoard*" : "");
      add(campaign, seed, test, failure);
    }
  }

  void add(Campaign& campaign, std::uint64_t seed, const std::string& test, const std::string& failure) {
    const std::scoped_lock lock{mutex_};
    totals_.cycles += campaign.cycles;
    totals_.readings += campaign.readings;
    totals_.tolerated += campaign.tolerated();
    totals_.goals += campaign.wire_judge.goalsSeen();
    totals_.tally += campaign.servo_judge.tally();
    for (std::size_t kind = 0; kind < hil::kFaultKinds; ++kind)
      totals_.faults[kind] += campaign.robot.faults().begun(static_cast<hil::FaultKind>(kind));
    if (!failure.empty()) {
      ++failed_;
      std::printf("%s\nagain: DARWINOP_SEED=%llu DARWINOP_CAMPAIGN_CYCLES=%ld campaign_test --gtest_filter=%s\n",
                  failure.c_str(), static_cast<unsigned long long>(seed), kShard, test.c_str());
    }
    const long percent = 100 * totals_.cycles / std::max(1L, wanted_);
    if (percent == shown_) return;
    shown_ = percent;
    std::printf("%3ld %%, %.0f cycles a second\n", percent, rate());
    std::fflush(stdout);
  }

  [[nodiscard]] double rate() const {
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin_;
    return static_cast<double>(totals_.cycles) / std::max(gone.count(), 1e-3);
  }

  void report() const {
    const ServoJudge::Tally& tally = totals_.tally;
    std::printf("\n%ld cycles (%.1f h of a robot's time), %.0f a second\n", totals_.cycles,
                static_cast<double>(totals_.cycles) * 0.016 / 3600, rate());
    std::printf("faults:");
    for (std::size_t kind = 0; kind < hil::kFaultKinds; ++kind)
      if (totals_.faults[kind] > 0)
        std::printf(" %s %llu", std::string{hil::kFaultKindNames[kind]}.c_str(),
                    static_cast<unsigned long long>(totals_.faults[kind]));
    std::printf(
        "\njudged: torque came on %ld times, %ld steps under torque, %ld goals on the wire, %ld readings, "
        "%ld limp joints, %ld outages, %ld releases, %ld shutdowns\n",
        tally.edges, tally.steps, totals_.goals, totals_.readings, tally.limp_looks, tally.outages, tally.releases,
        tally.trips);
    std::fputs(darwinop::report(totals_.tolerated).c_str(), stdout);
    if (failed_ == 0)
      std::puts("result: every promise held");
    else
      std::printf("result: %d shards failed, see above\n", failed_.load());
  }

  long wanted_;
  std::uint64_t seed_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::atomic<long> next_shard_{0};
  std::atomic<int> failed_{0};
  std::mutex mutex_;
  Totals totals_;
  long shown_ = -1;
};

}  // namespace
}  // namespace darwinop

int main(int argc, char** argv) {
  const long cycles = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 100'000'000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : std::random_device{}();
  return darwinop::Deep{cycles, seed}.run();
}
