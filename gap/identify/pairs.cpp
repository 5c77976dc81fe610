// Where the search began at a saddle: of two effects that nearly cancel each other neither gains anything alone, and
// what does is a stand-in.
#include <algorithm>
#include <optional>

#include "gap/identify/selection.hpp"

namespace darwinop::gap {
namespace {

/// What any servo has, and what its commands pass through: friction of three kinds, zero offset, delay, limits of the
/// set point.
std::vector<const twin::EffectInfo*> basicOf(const std::vector<const twin::EffectInfo*>& candidates) {
  std::vector<const twin::EffectInfo*> basic;
  std::ranges::copy_if(candidates, std::back_inserter(basic), [](const twin::EffectInfo* effect) {
    return effect->prevalence == twin::Prevalence::kCommon || effect->part == twin::LoopPart::kCommand;
  });
  return basic;
}

/// The baseline with both effects of the pair, from where the screen saw them.
FittedModel fitPair(const FittedModel& bare, const CandidatePair& pair) {
  const Effects effects{{pair.one.effect}, {pair.other.effect}};
  const Problem problem = problemWith(*bare.study, *bare.evidence, effects, bare.nuisance);
  Eigen::VectorXd x = startFrom(problem, bare.problem, bare.fit.x);
  std::vector<double> values = pair.one.values;
  values.insert(values.end(), pair.other.values.begin(), pair.other.values.end());
  const auto own = static_cast<Eigen::Index>(values.size());
  for (Eigen::Index k = 0; k < own; ++k) {
    const Eigen::Index at = x.size() - own + k;
    x[at] = problem.unknowns()[static_cast<std::size_t>(at)].toSearch(values[static_cast<std::size_t>(k)]);
  }
  Fit fit = solve(problem, x, {.iterations = thresholds::kShortlistIterations, .refine = false});
  const double total = fit.cost + bare.evidence->logDeterminant();
  return {bare.study, effects, bare.nuisance, bare.evidence, problem, std::move(fit), total};
}

}  // namespace

bool Selection::beganAtASaddle() const {
  return first_share_ < thresholds::kSaddleShare && !(model_.effects.empty() && leavesNoise());
}

/// Both effects are needed, inside their ranges, and no number that stays within its prior; only noise is left. Of a
/// gap that nothing explains some pair always explains more than one effect.
bool Selection::isSound(const FittedModel& pair) const {
  for (std::size_t i = 0; i < pair.effects.size(); ++i) {
    const twin::EffectInfo& effect = *pair.effects[i].info;
    if (isAtItsBound(pair, effect) || isNegligible(pair, effect) || staysInsideItsPrior(pair, effect)) return false;
    if (refitWithout(pair, i).fit.cost - pair.fit.cost < leastGain(study_, pair.hypothesis(), effect, threshold_))
      return false;
  }
  return misfitOf(pair, bootstrapOf(pair, nullptr, thresholds::kFewBootstrapRuns)) < thresholds::kMisfitSigmas;
}

bool Selection::takeBetterPair() {
  std::vector<CandidatePair> pairs = Screen{bare_, basicOf(candidates_)}.pairs();
  pairs.resize(std::min(pairs.size(), thresholds::kFittedPairs));
  std::optional<FittedModel> best;
  for (const CandidatePair& pair : pairs)
    if (FittedModel fitted = fitPair(bare_, pair); !best || fitted.fit.cost < best->fit.cost) best = std::move(fitted);
  if (!best || !(best->fit.cost < bare_.fit.cost)) return false;
  const FittedModel pair = refit(*best, best->effects, 2);
  // Each under the noise of the other: the pair has to be ahead under both.
  const FittedModel here = refitUnderNoiseOf(model_, pair, true), there = refitUnderNoiseOf(pair, model_, true);
  const double ahead =
      std::min(modelEvidence(pair) - modelEvidence(here), modelEvidence(there) - modelEvidence(model_));
  report("%s and %s together: ahead by %.0f", std::string{pair.effects[0].info->id}.c_str(),
         std::string{pair.effects[1].info->id}.c_str(), ahead);
  if (ahead < thresholds::kRivalEvidence || !isSound(pair)) return false;
  model_ = pair;
  gains_ = {gainOf(0), gainOf(1)};
  rivals_.clear(), rejected_.clear();
  prune();
  return true;
}

}  // namespace darwinop::gap
