#include "gap/plan/question.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gap/case/data_check.hpp"
#include "gap/identify/effect_set.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plan/thresholds.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

std::vector<std::string> idsFound(const Identification& identification) {
  std::vector<std::string> ids;
  for (const IdentifiedEffect& found : identification.effects) ids.emplace_back(found.effect->id);
  return ids;
}

/// Effects that these logs cannot show, by the data check.
std::vector<const twin::EffectInfo*> hiddenOnes(const Case& given) {
  std::vector<const twin::EffectInfo*> hidden;
  const std::vector<const twin::EffectInfo*> candidates = candidateEffectsOf(given);
  for (const DataFinding& finding : checkData(given).findings) {
    if (finding.reveals) continue;
    for (const twin::EffectInfo* const effect : candidates)
      if (std::ranges::find(finding.effects, effect->id) != finding.effects.end() &&
          std::ranges::find(hidden, effect) == hidden.end())
        hidden.push_back(effect);
  }
  return hidden;
}

/// The first hypothesis with an effect of the size that is typical of this servo family.
FittedHypothesis typically(const FittedHypothesis& present, const twin::EffectInfo& effect) {
  FittedHypothesis with{
      .name = std::string{effect.id}, .hypothesis = present.best(), .unknowns = {}, .x = {}, .information = {}};
  const bool there = with.hypothesis.find(effect.id) != nullptr;
  twin::EffectSetting& setting = with.hypothesis.with(effect);
  for (std::size_t i = 0; i < setting.values.size(); ++i)
    setting.values[i] = there ? (1 + thresholds::kMoreOfAnEffect) * setting.values[i] : effect.parameters[i].typical;
  return with;
}

/// Index of the effects' parameter, or of any where there is none, whose interval is widest relative to its value.
std::size_t widest(const FittedHypothesis& hypothesis) {
  const Eigen::VectorXd sigmas = hypothesis.sigmas();
  std::size_t found = 0;
  double most = -1;
  for (std::size_t i = 0; i < hypothesis.unknowns.size(); ++i) {
    const Unknown& unknown = hypothesis.unknowns[i];
    const auto at = static_cast<Eigen::Index>(i);
    const double value = std::abs(unknown.fromSearch(hypothesis.x[at]));
    const double share = unknown.logarithmic ? sigmas[at] : sigmas[at] / std::max(value, 1e-9);
    const bool own = !std::isfinite(unknown.sigma);  // numbers of the baseline have priors
    const double rank = own ? 1e6 + share : std::isfinite(unknown.sigma) ? sigmas[at] / unknown.sigma : share;
    if (rank > most) most = rank, found = i;
  }
  return found;
}

}  // namespace

Question questionAfter(const Case& given, const Identification& identification, const ProgressCallback& progress) {
  std::vector<std::vector<std::string>> sets{idsFound(identification)};
  for (const Rival& rival : identification.rivals)
    if (rival.behind < thresholds::kRivalEvidence && sets.size() <= thresholds::kMostPlannedRivals &&
        !identification.effects.empty() && std::ranges::find(sets, rival.effects) == sets.end())
      sets.push_back(rival.effects);
  Question question{Aim::kSeparate, fitHypotheses(given, sets, progress), 0};
  if (question.hypotheses.size() > 1) return question;
  if (identification.effects.empty()) {
    question.aim = Aim::kReveal;
    for (const twin::EffectInfo* const effect : hiddenOnes(given))
      question.hypotheses.push_back(typically(question.hypotheses.front(), *effect));
    if (question.hypotheses.size() > 1) return question;
  }
  question.aim = Aim::kNarrow;
  if (question.hypotheses.front().unknowns.empty())
    throw std::runtime_error(
        "nothing is missing, these logs could show every effect, and no number is free: there is nothing to plan");
  question.unknown = widest(question.hypotheses.front());
  return question;
}

Question questionBetween(const Case& given, const std::vector<std::string>& ids, const ProgressCallback& progress) {
  std::vector<std::vector<std::string>> sets;
  for (const std::string& id : ids) {
    const std::vector<std::string> set{id};
    if (std::ranges::find(sets, set) != sets.end())
      throw std::runtime_error("'" + id + "' " + messages::kEffectGivenTwice);
    sets.push_back(set);
  }
  if (sets.size() == 1) sets.insert(sets.begin(), std::vector<std::string>{});
  return {Aim::kSeparate, fitHypotheses(given, sets, progress), 0};
}

}  // namespace darwinop::gap
