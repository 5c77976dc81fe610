#include "gap/plan/ranking.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "gap/parallel/parallel.hpp"
#include "gap/plan/commands.hpp"
#include "gap/plan/prediction.hpp"
#include "gap/plan/thresholds.hpp"

namespace darwinop::gap {
namespace {

bool samePhase(const experiments::Phase& a, const experiments::Phase& b) {
  const experiments::Goal &p = a.goal, &q = b.goal;
  return p.shape == q.shape && p.to == q.to && p.amplitude == q.amplitude && p.period_s == q.period_s && p.hz == q.hz &&
         p.goals == q.goals && p.every_s == q.every_s && a.duration_s == b.duration_s && a.velocity == b.velocity &&
         a.p_gain == b.p_gain && a.torque == b.torque;
}

/// A repeated round shows the noise, and adds little about effects: it counts once.
std::vector<Stretch> distinctCommands(const ExperimentCandidate& candidate, const ArmSetup& stand) {
  std::vector<Stretch> all;
  const auto& rounds = candidate.experiment.rounds;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    const auto before = rounds.begin() + static_cast<std::ptrdiff_t>(i);
    const bool again = std::any_of(rounds.begin(), before, [&](const experiments::Round& other) {
      return std::ranges::equal(other.phases, rounds[i].phases, samePhase);
    });
    if (again) continue;
    for (Stretch& stretch : commandsOf(candidate, rounds[i], stand)) all.push_back(std::move(stretch));
  }
  return all;
}

std::vector<std::pair<std::size_t, std::size_t>> pairsOf(const Question& question) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < question.hypotheses.size(); ++a)
    for (std::size_t b = a + 1; b < question.hypotheses.size(); ++b)
      if (question.aim == Aim::kSeparate || (question.aim == Aim::kReveal && a == 0)) pairs.emplace_back(a, b);
  return pairs;
}

/// Expected log likelihood ratio of the true hypothesis to its nearest rival, averaged over the hypotheses.
double nearestOnes(const Question& question, const std::vector<Separation>& separations) {
  double sum = 0;
  for (std::size_t right = 0; right < question.hypotheses.size(); ++right) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Separation& one : separations)
      if (one.a == right || one.b == right) nearest = std::min(nearest, one.sigma);
    sum += std::pow(std::min(nearest, thresholds::kSurelySeparated), 2) / 2;
  }
  return sum / static_cast<double>(question.hypotheses.size());
}

double shownOnes(const std::vector<Separation>& separations) {
  double sum = 0;
  for (const Separation& one : separations) sum += std::pow(std::min(one.sigma, thresholds::kCertainToShow), 2) / 2;
  return sum;
}

double sigmaOf(const Eigen::MatrixXd& information, std::size_t unknown) {
  const auto at = static_cast<Eigen::Index>(unknown);
  return std::sqrt(std::max(0.0, information.ldlt().solve(Eigen::VectorXd::Unit(information.rows(), at))[at]));
}

void judge(const Case& given, const ArmSetup& stand, const Question& question, int noise_runs, Ranked& ranked) {
  const Case coming = planned(given, distinctCommands(ranked.vetted.candidate, stand));
  std::vector<Prediction> predictions;
  predictions.reserve(question.hypotheses.size());
  for (const FittedHypothesis& hypothesis : question.hypotheses) {
    const bool judges =
        question.aim != Aim::kReveal || predictions.empty();  // the first one, the present model, defines the noise
    predictions.push_back(predict(coming, hypothesis, judges ? noise_runs : 0));
  }
  for (const auto& [a, b] : pairsOf(question))
    ranked.separations.push_back(
        {a, b, separationOf(coming, question.hypotheses[a], predictions[a], question.hypotheses[b], predictions[b])});
  if (question.aim == Aim::kNarrow) {
    const Eigen::MatrixXd& known = question.hypotheses[0].information;
    ranked.sigma_before = sigmaOf(known, question.unknown);
    ranked.sigma_after = sigmaOf(known + informationFrom(coming, predictions[0]), question.unknown);
    ranked.gain = std::log(ranked.sigma_before / ranked.sigma_after);
  } else {
    ranked.gain =
        question.aim == Aim::kSeparate ? nearestOnes(question, ranked.separations) : shownOnes(ranked.separations);
  }
}

}  // namespace

NextExperiments nextExperiments(const Case& given, const ArmSetup& stand, Question question,
                                const std::vector<ExperimentCandidate>& candidates, int noise_runs) {
  std::vector<Hypothesis> hypotheses;
  for (const FittedHypothesis& hypothesis : question.hypotheses) hypotheses.push_back(hypothesis.best());
  std::vector<std::optional<Ranked>> judged(candidates.size());
  std::vector<Refusal> refused(candidates.size());
  forEach(candidates.size(), [&](std::size_t i) {
    Ranked ranked;
    ranked.vetted = vetted(candidates[i], stand, given, hypotheses);
    if (ranked.vetted.refused.empty()) {
      try {
        judge(given, stand, question, noise_runs, ranked);
        judged[i] = std::move(ranked);
      } catch (const std::runtime_error& impossible) {  // an unknown moved to where there is no inertia left
        refused[i] = {candidates[i].experiment.name, impossible.what()};
      }
    } else {
      refused[i] = {candidates[i].experiment.name, ranked.vetted.refused};
    }
  });
  NextExperiments next{std::move(question), stand, {}, {}};
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (judged[i])
      next.ranked.push_back(std::move(*judged[i]));
    else
      next.refused.push_back(std::move(refused[i]));
  std::stable_sort(next.ranked.begin(), next.ranked.end(),
                   [](const Ranked& a, const Ranked& b) { return a.perMinute() > b.perMinute(); });
  return next;
}

}  // namespace darwinop::gap
