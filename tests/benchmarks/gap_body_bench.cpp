// darwinop gap of the whole robot in figures: roll-outs, scaling with joints, logs and cores; beside it the plain way,
// which simulates the whole robot for each number of each effect in each joint (docs/performance.md).
//
//   gap_body_bench rollout | scaling | plain
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "gap/benchmark/body/body_suite.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap/identify/body/mechanical_effect.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/body/floor_roll_out.hpp"
#include "twin/body/robot_body.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::gap;

/// Ten recordings with a friction that the model does not have.
const BodyCase& hiddenCase() {
  static const BodyCase kCase = hiddenBody(bodyRequestsFor(4711, {"coulomb"}).front()).given;
  return kCase;
}

/// Wall time of `run`, s.
template <class Run>
double timeOf(Run&& run) {
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The same, best of five.
template <class Run>
double bestTimeOf(Run&& run) {
  double best = timeOf(run);
  for (int turn = 1; turn < 5; ++turn) best = std::min(best, timeOf(run));
  return best;
}

void print(const std::string& name, double ours, double peer, const char* unit) {
  std::printf("bench: %s ours=%.4g peer=%.4g ratio=%.3f unit=%s\n", name.c_str(), ours, peer, ours / peer, unit);
  std::fflush(stdout);
}

/// The twin's whole body with the trunk in the stand follows the goals of a log.
void simulateWholeBody(const BodyCase& given, std::size_t log) {
  const BodyLog& of = given.logs[log];
  twin::RobotBody body{given.joints.model, {.ball = twin::Ball::kNone, .clamped_up = of.up}};
  Drives drives{};
  for (std::size_t row = 1; row < of.rows(); ++row) {
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      drives[joint] = {.torque_on = true, .goal_rad = given.joint(log, joint).goal_rad[row]};
    body.step(Nanos{static_cast<std::int64_t>(1e9 * (of.time_s[row] - of.time_s[row - 1]))}, drives);
  }
}

void simulateLimbs(const BodyCase& given, std::size_t log, const std::vector<Limb>& limbs) {
  const BodyHypothesis robot = declaredRobot(given);
  for (const Limb& limb : limbs) rollOut(given, log, limb, robot);
}

std::size_t firstLog(const BodyCase& given, BodySetup setup) {
  return static_cast<std::size_t>(std::ranges::find(given.logs, setup, &BodyLog::setup) - given.logs.begin());
}

// A log with a clamped trunk, one core. Peer: the twin's whole body over the same time.
void rollOuts() {
  const BodyCase& given = hiddenCase();
  const std::size_t clamped = firstLog(given, BodySetup::kClamped), floor = firstLog(given, BodySetup::kFloor);
  const std::vector<Limb> limbs = limbsOf(given.joints.model);
  const double whole = bestTimeOf([&] { simulateWholeBody(given, clamped); });
  std::printf("a log of %.1f s\n", given.logs[clamped].time_s.back());
  print("gap_body_rollouts_all_limbs", 1 / bestTimeOf([&] { simulateLimbs(given, clamped, limbs); }), 1 / whole, "1/s");
  for (const Limb& limb : limbs) {
    const double one = bestTimeOf([&] { simulateLimbs(given, clamped, {limb}); });
    print("gap_body_rollouts_" + std::to_string(limb.size()) + "_joints", 1 / one, 1 / whole, "1/s");
  }
  const double on_floor =
      bestTimeOf([&] { rollOut(given, floor, FloorHypothesis{.robot = declaredRobot(given), .floor = {}}); });
  std::printf("on the floor, a log of %.1f s with rest before it: %.3g 1/s\n", given.logs[floor].time_s.back(),
              1 / on_floor);
}

double timeOf(const BodyCase& given, unsigned threads) {
  setThreads(threads);
  return timeOf([&] { identify(given); });
}

/// Without the third, the fifth and the seventh log.
BodyCase halfOf(const BodyCase& given) {
  BodyCase half = given;
  half.logs.clear(), half.joints.logs.clear();
  for (std::size_t log = 0; log < given.logs.size(); ++log) {
    if (log > 0 && log % 2 == 0 && !given.logs[log].held_out) continue;
    half.logs.push_back(given.logs[log]);  // repeat_of: the first log stays where it is
    for (std::size_t joint = 0; joint < kJoints; ++joint) half.joints.logs.push_back(given.joint(log, joint));
  }
  return half;
}

// A whole case. Peers: one thread; some of the logs that are fitted.
void scaling() {
  const BodyCase& given = hiddenCase();
  const BodyCase half = halfOf(given);
  const double two = timeOf(given, 2);
  print("gap_body_case_2_threads_over_1", two, timeOf(given, 1), "s");
  std::printf("%zu logs, and %zu\n", given.logs.size(), half.logs.size());
  print("gap_body_case_all_logs_over_some", two, timeOf(half, 2), "s");
}

// A whole case. Peer: one derivative of every clamped log by every number of every effect in every joint, by the whole
// body: computed from the time of one roll-out of each log, as if two threads halved it. A search takes many of them.
void plain() {
  const BodyCase& given = hiddenCase();
  std::size_t numbers = 0;
  for (const MechanicalEffect& effect : mechanicalEffects()) numbers += kJoints * effect.numbers.size();
  double once = 0;
  for (std::size_t log = 0; log < given.logs.size(); ++log)
    if (given.logs[log].setup == BodySetup::kClamped && !given.logs[log].held_out)
      once += timeOf([&] { simulateWholeBody(given, log); });
  std::printf("%zu numbers of effects in joints\n", numbers);
  constexpr unsigned kThreads = 2;
  print("gap_body_case_over_plain_jacobian", timeOf(given, kThreads), static_cast<double>(numbers) * once / kThreads,
        "s");
}

}  // namespace

int main(int count, char** words) {
  const std::string_view wanted = count > 1 ? words[1] : "";
  if (wanted == "rollout") return rollOuts(), 0;
  if (wanted == "scaling") return scaling(), 0;
  if (wanted == "plain") return plain(), 0;
  std::fprintf(stderr, "usage: gap_body_bench rollout | scaling | plain\n");
  return 2;
}
