// Hypotheses of the small bench, made by hand, and the plan to distinguish them.
#pragma once

#include "gap/plan/bench_experiments.hpp"
#include "gap/plan/ranking.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {

/// One effect at one value, which may be off by `sigma` of the search variable; the case's numbers by their priors.
inline FittedHypothesis hypothesisWith(const Case& bench, std::string_view id, std::string_view key, double value,
                                       double sigma) {
  FittedHypothesis made;
  made.name = id;
  made.hypothesis = withEffect(bench, id, key, value);
  for (Unknown& unknown : nuisancesOf(bench, made.hypothesis))
    if (unknown.name == "kt" || unknown.name == "payload") made.unknowns.push_back(std::move(unknown));
  made.unknowns.push_back(unknownsOf(*twin::findEffect(id)).front());
  const auto count = static_cast<Eigen::Index>(made.unknowns.size());
  made.x.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Unknown& unknown = made.unknowns[static_cast<std::size_t>(i)];
    made.x[i] = unknown.toSearch(i + 1 == count ? value : unknown.expected);
  }
  made.information = informationOf(made.unknowns, made.x, Eigen::MatrixXd::Zero(0, count));
  made.information(count - 1, count - 1) += 1 / (sigma * sigma);
  return made;
}

inline ExperimentCandidate named(const std::string& name, const ArmSetup& stand = armSetupFor(Joint::kShoulderR)) {
  for (experiments::Experiment& experiment : benchExperiments(stand))
    if (experiment.name == name)
      return {.experiment = std::move(experiment), .payload_kg = 0.3, .prepare = {}, .prepare_s = 0};
  throw std::logic_error("no bench experiment " + name);
}

inline constexpr int kFewRuns = 6;  // of the noise

inline std::vector<std::string> namesOf(const NextExperiments& next) {
  std::vector<std::string> names;
  for (const Ranked& ranked : next.ranked) names.push_back(ranked.vetted.candidate.experiment.name);
  return names;
}

}  // namespace darwinop::gap
