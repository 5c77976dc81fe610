#include "gap/plan/body/motion_ranking.hpp"

#include <algorithm>
#include <cmath>

#include "gap/parallel/parallel.hpp"
#include "gap/plan/thresholds.hpp"

namespace darwinop::gap {
namespace {

using thresholds::kCertainToShow;

/// In the order of RankedMotion::differences.
std::vector<SignalDifference> differencesIn(const BodyCase& coming, std::size_t log, const BodyQuestion& question) {
  const std::size_t count = question.models.size();
  std::vector<std::vector<PredictedSignal>> signals;
  for (std::size_t i = 0; i < count; ++i) {
    const bool with_noise = i == 0 || (question.is_rivalry && i + 1 < count);
    signals.push_back(predictedSignals(coming, log, question.models[i].model, with_noise));
  }
  std::vector<SignalDifference> out;
  for (std::size_t a = 0; a < (question.is_rivalry ? count : 1); ++a)
    for (std::size_t b = a + 1; b < count; ++b) out.push_back(differenceOf(signals[a], signals[b]));
  return out;
}

double gainOf(double sigma) {
  return std::pow(std::min(sigma, kCertainToShow), 2) / 2;
}

/// Without the effects that the recordings for fits show.
BodyQuestion withoutShown(const BodyCase& given, BodyQuestion question) {
  std::vector<std::size_t> logs = floorLogs(given, false);
  for (std::size_t log = 0; log < given.logs.size(); ++log)
    if (given.logs[log].setup == BodySetup::kClamped && !given.logs[log].held_out && !given.logs[log].repeat_of)
      logs.push_back(log);
  std::vector<std::vector<SignalDifference>> shown(logs.size());
  forEach(logs.size(), [&](std::size_t i) { shown[i] = differencesIn(given, logs[i], question); });
  std::vector<RivalModel> kept{question.models.front()};
  for (std::size_t model = 1; model < question.models.size(); ++model) {
    double square = 0;
    for (const auto& of_log : shown) square += std::pow(of_log[model - 1].sigma, 2);
    if (!(std::sqrt(square) > kCertainToShow)) kept.push_back(question.models[model]);
  }
  question.models = std::move(kept);
  return question;
}

/// Effects of sensor, floor and trunk do not need other motions of the limbs in the air.
bool isForReveal(const PlannedMotion& motion) {
  if (motion.setup == BodySetup::kClamped) return motion.experiment == "body_triangles";
  return !motion.experiment.starts_with("bow");
}

/// Of a motion on the floor: the case has recordings there that are simulated, so more can be made in the same way.
bool canUseFloor(const BodyCase& given) {
  return !floorLogs(given, false).empty() || !floorLogs(given, true).empty();
}

}  // namespace

BodyPlan nextMotions(const BodyCase& given, BodyQuestion question, std::vector<PlannedMotion> motions) {
  BodyPlan out;
  if (!canUseFloor(given)) {
    const auto is_on_floor = [](const PlannedMotion& one) { return one.setup != BodySetup::kClamped; };
    for (const PlannedMotion& one : motions)
      if (is_on_floor(one)) out.left_out.push_back(one.name());
    std::erase_if(motions, is_on_floor);
  }
  if (!question.is_rivalry) {
    question = withoutShown(given, std::move(question));
    std::erase_if(motions, [](const PlannedMotion& one) { return !isForReveal(one); });
  }
  out.question = std::move(question);
  if (out.question.models.size() < 2) return out;
  const BodyCase coming = planned(given, motions);
  out.ranked.resize(motions.size());
  forEach(motions.size(), [&](std::size_t i) {
    RankedMotion& one = out.ranked[i];
    one.motion = motions[i];
    one.differences = differencesIn(coming, i, out.question);
    const auto nearest = std::ranges::min_element(one.differences, {}, &SignalDifference::sigma);
    if (out.question.is_rivalry) one.gain = gainOf(nearest->sigma);
    for (const SignalDifference& difference : one.differences)
      if (!out.question.is_rivalry) one.gain += gainOf(difference.sigma);
  });
  std::ranges::stable_sort(out.ranked, std::greater{}, &RankedMotion::perMinute);
  return out;
}

}  // namespace darwinop::gap
