// darwinop gap in figures: roll-outs, a whole case, scaling; beside it a global optimiser on one friction model, as
// other tools fit servos (docs/performance.md).
//
//   gap_bench rollout | scaling | peer
#include <nlopt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gap/benchmark/make/make_case.hpp"
#include "gap/identify/assessment.hpp"
#include "gap/identify/identification.hpp"
#include "gap/parallel/parallel.hpp"
#include "twin/effects/catalogue.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::gap;

constexpr int kTrials = 100'000;
constexpr double kMrad = 1e3;

/// Ten logs of seven seconds with a friction that the baseline does not have.
Hidden hiddenCase() {
  CaseRequest request;
  request.seed = 4711;
  request.effects.push_back({.id = "stribeck", .values = {}, .severity = 2});
  return hidden(request);
}

class Watch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

void print(const std::string& name, double ours, double peer, const char* unit) {
  std::printf("bench: %s ours=%.4g peer=%.4g ratio=%.3f unit=%s\n", name.c_str(), ours, peer, ours / peer, unit);
  std::fflush(stdout);
}

/// CPU time of `run`, best of five, s.
template <class Run>
double cpuTime(Run&& run) {
  double best = 1e9;
  for (int turn = 0; turn < 5; ++turn) {
    const std::clock_t begin = std::clock();
    run();
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return best;
}

// Roll-outs of a log a second and core. Peer: the same bench of the twin, stepped as long with one goal.
void rollOuts() {
  const Case given = hiddenCase().given;
  const Hypothesis hypothesis = baselineOf(given);
  constexpr int kRuns = 200;
  Trace trace;
  const double ours = cpuTime([&] {
    for (int i = 0; i < kRuns; ++i) rollOut(given, 0, hypothesis, {}, trace);
  });
  const double peer = cpuTime([&] {
    for (int i = 0; i < kRuns; ++i) {
      std::vector<std::unique_ptr<twin::Effect>> effects;
      for (const twin::EffectSetting& effect : hypothesis.effects) effects.push_back(effect.info->make(effect.values));
      twin::Pendulum pendulum = hypothesis.pendulum;
      pendulum.payload_kg = given.logs[0].payload_kg;
      twin::Bench bench{hypothesis.servo, std::move(effects), pendulum};
      bench.reset({.steps_per_period = 1});
      const ServoDrive drive{.torque_on = true, .goal_rad = 0.5, .p_gain = given.logs[0].p_register / 8};
      const auto periods = std::lround((given.logs[0].duration_s() + 1) / hypothesis.servo.firmware_period_s);
      for (long period = 0; period < periods; ++period) bench.step(drive);
    }
  });
  std::printf("a log of %.1f s\n", given.logs[0].duration_s());
  print("gap_rollouts", kRuns / ours, kRuns / peer, "1/s");
}

double timeOf(const Case& given, unsigned threads) {
  setThreads(threads);
  const Watch watch;
  identify(Study{given});
  return watch.seconds();
}

// A whole case. Peers: one thread; every other of the logs that are fitted.
void scaling() {
  const Case given = hiddenCase().given;
  Case half = given;
  half.logs.clear();
  for (std::size_t i = 0; i < given.logs.size(); ++i)
    if (i % 2 == 0 || given.logs[i].held_out) half.logs.push_back(given.logs[i]);
  const double two = timeOf(given, 2);
  print("gap_case_2_threads_over_1", two, timeOf(given, 1), "s");
  std::printf("%zu logs, and %zu\n", given.logs.size(), half.logs.size());
  print("gap_case_all_logs_over_half", two, timeOf(half, 2), "s");
}

struct Fitting {
  const Case& given;
  const Problem& problem;
  std::vector<double> squares;  // of each log
  int trials = 0;
};

/// Rms position error over the logs for fitting: what others minimise.
double rmsError(unsigned count, const double* x, double* /*jacobian*/, void* data) {
  auto& fitting = *static_cast<Fitting*>(data);
  ++fitting.trials;
  const Hypothesis hypothesis =
      fitting.problem.at(Eigen::Map<const Eigen::VectorXd>(x, static_cast<Eigen::Index>(count)));
  fitting.squares.assign(fitting.given.logs.size(), 0);
  forEach(fitting.given.logs.size(), [&](std::size_t i) {
    const Trajectory& log = fitting.given.logs[i];
    if (log.held_out) return;
    thread_local Trace trace;
    rollOut(fitting.given, i, hypothesis, {}, trace);
    for (std::size_t row = 0; row < log.rows(); ++row)
      fitting.squares[i] +=
          std::pow(log.position_rad[row] - trace.position_rad[row], 2) / static_cast<double>(log.rows());
  });
  double sum = 0;
  for (const double square : fitting.squares) sum += square;
  return std::sqrt(sum);
}

// The same data to the end: gap finds which effect it is and fits it; the peer gets the right kind of friction, and
// searches the ranges of its numbers (controlled random search, Kaelo and Ali 2006) with as many trials as others take.
void peer() {
  const Hidden made = hiddenCase();
  const Case& given = made.given;
  const Watch ours;
  const Identification naming = identify(Study{given});
  const double our_time = ours.seconds(), our_error = rmsPositionError(given, naming.model, LogRole::kHeldOut);
  std::printf("gap: %s, %zu effects\n", std::string{nameOf(naming.verdict)}.c_str(), naming.effects.size());

  const Study study{given};
  const Problem problem = problemWith(
      study, study.evidence,
      {{twin::findEffect("coulomb")}, {twin::findEffect("viscous")}, {twin::findEffect("stribeck")}}, Nuisance::kFree);
  std::vector<double> low, high, x;
  for (const Unknown& unknown : problem.unknowns()) {
    low.push_back(unknown.toSearch(unknown.low));
    high.push_back(unknown.toSearch(unknown.high));
    x.push_back(unknown.toSearch(unknown.expected));
  }
  const auto count = static_cast<unsigned>(x.size());
  nlopt_opt search = nlopt_create(NLOPT_GN_CRS2_LM, count);
  nlopt_set_lower_bounds(search, low.data());
  nlopt_set_upper_bounds(search, high.data());
  nlopt_set_maxeval(search, kTrials);
  nlopt_srand(1);
  Fitting fitting{given, problem, {}};
  nlopt_set_min_objective(search, rmsError, &fitting);
  double least = 0;
  const Watch theirs;
  nlopt_optimize(search, x.data(), &least);
  const double their_time = theirs.seconds();
  nlopt_destroy(search);
  const Hypothesis found = problem.at(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(count)));
  std::printf("peer: %u numbers, %d trials\n", count, fitting.trials);
  print("gap_case_time", our_time, their_time, "s");
  print("gap_case_kept_error", kMrad * our_error, kMrad * rmsPositionError(given, found, LogRole::kHeldOut), "mrad");
  std::printf("held-out logs of the baseline: %.4g mrad; of the bench that made them, without noise: %.4g mrad\n",
              kMrad * made.key.gap_held_out_rad, kMrad * made.key.noise_held_out_rad);
}

}  // namespace

int main(int count, char** words) {
  const std::string_view wanted = count > 1 ? words[1] : "";
  if (wanted == "rollout") return rollOuts(), 0;
  if (wanted == "scaling") return scaling(), 0;
  if (wanted == "peer") return peer(), 0;
  std::fprintf(stderr, "usage: gap_bench rollout | scaling | peer\n");
  return 2;
}
