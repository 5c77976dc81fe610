#include "gap/identify/shortlist.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "gap/identify/ripple_starts.hpp"
#include "gap/identify/rough_selection.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

struct ShortlistEntry {
  const twin::EffectInfo* effect = nullptr;
  Eigen::VectorXd start;
  double predicted_gain = 0;
  bool refined = false;  // the secondary parameters are free as well
  std::optional<Problem> problem = std::nullopt;
  Fit fit = {};
};

Effects withOneMore(const FittedModel& present, const twin::EffectInfo& effect, bool refined = false) {
  Effects effects = present.effects;
  effects.push_back({&effect, refined});
  return effects;
}

std::vector<Candidate> promising(const Screen& screen, const std::vector<const twin::EffectInfo*>& only,
                                 std::size_t most = thresholds::kRefinedEffects) {
  std::vector<Candidate> chosen;
  std::map<const twin::EffectInfo*, std::size_t> starts;
  for (const Candidate& candidate : screen.candidates()) {
    if (!only.empty() && std::find(only.begin(), only.end(), candidate.effect) == only.end()) continue;
    const bool wanted = starts.contains(candidate.effect) || starts.size() < most;
    if (wanted && starts[candidate.effect]++ < thresholds::kStartsPerEffect) chosen.push_back(candidate);
  }
  return chosen;
}

/// Two starts of one effect that lead to the same fit. A fit cannot cross from one count of ripples to the next.
bool startAlike(const Candidate& one, const Candidate& other) {
  return one.effect == other.effect && (!isRipple(*one.effect) || std::abs(one.values[1] - other.values[1]) < 1);
}

/// The best starts of each effect that differ, best first.
std::vector<ShortlistEntry> refinedStarts(const Screen& screen, const std::vector<Candidate>& candidates) {
  std::vector<RefinedStart> starts(candidates.size());
  forEach(candidates.size(), [&](std::size_t i) { starts[i] = screen.refinedStart(candidates[i]); });
  std::stable_sort(starts.begin(), starts.end(), [](const RefinedStart& a, const RefinedStart& b) {
    return a.candidate.predicted_gain > b.candidate.predicted_gain;
  });
  std::vector<ShortlistEntry> best;
  std::vector<const Candidate*> seen;
  for (RefinedStart& one : starts) {
    const auto alike = [&](const Candidate* other) { return startAlike(*other, one.candidate); };
    if (std::any_of(seen.begin(), seen.end(), alike)) continue;
    seen.push_back(&one.candidate);
    best.push_back({one.candidate.effect, std::move(one.x), one.candidate.predicted_gain});
  }
  return best;
}

/// The first so many effects, with all of their starts.
void keepFirst(std::size_t most, std::vector<ShortlistEntry>& entries) {
  std::set<const twin::EffectInfo*> kept;
  std::erase_if(entries, [&](const ShortlistEntry& entry) {
    if (kept.size() < most) kept.insert(entry.effect);
    return !kept.contains(entry.effect);
  });
}

/// The best start of each effect, of entries that are fitted.
void keepBestStarts(std::vector<ShortlistEntry>& entries) {
  std::set<const twin::EffectInfo*> kept;
  std::erase_if(entries, [&](const ShortlistEntry& entry) { return !kept.insert(entry.effect).second; });
}

/// An effect may start from a baseline number that the present model has moved within its prior.
void addKnown(const FittedModel& present, std::vector<ShortlistEntry>& entries) {
  std::vector<ShortlistEntry> known;
  for (const ShortlistEntry& entry : entries) {
    const auto own = unknownsOf(*entry.effect);
    const bool all = !own.empty() && std::all_of(own.begin(), own.end(), [&](const Unknown& one) {
      return std::any_of(present.problem.unknowns().begin(), present.problem.unknowns().end(),
                         [&](const Unknown& other) { return other.name == one.name; });
    });
    if (!all) continue;
    const Problem problem =
        problemWith(*present.study, *present.evidence, withOneMore(present, *entry.effect), present.nuisance);
    known.push_back({entry.effect, startFrom(problem, present.problem, present.fit.x), entry.predicted_gain});
  }
  entries.insert(entries.end(), known.begin(), known.end());
}

/// The same starts, with the baseline numbers at their expected values.
void addAfresh(const FittedModel& present, std::vector<ShortlistEntry>& entries) {
  for (std::size_t i = 0, count = entries.size(); i < count; ++i) {
    ShortlistEntry afresh = entries[i];
    const Problem problem =
        problemWith(*present.study, *present.evidence, withOneMore(present, *afresh.effect), present.nuisance);
    const Eigen::VectorXd expected = problem.expected();
    for (std::size_t k = 0; k < problem.unknowns().size(); ++k)
      if (std::isfinite(problem.unknowns()[k].sigma))
        afresh.start[static_cast<Eigen::Index>(k)] = expected[static_cast<Eigen::Index>(k)];
    entries.push_back(std::move(afresh));
  }
}

void fitAll(const FittedModel& present, std::vector<ShortlistEntry>& entries) {
  forEach(entries.size(), [&](std::size_t i) {
    ShortlistEntry& entry = entries[i];
    entry.problem.emplace(
        problemWith(*present.study, *present.evidence, withOneMore(present, *entry.effect), present.nuisance));
    entry.fit = solve(*entry.problem, entry.start, {.iterations = thresholds::kShortlistIterations, .refine = false});
  });
  std::stable_sort(entries.begin(), entries.end(),
                   [](const ShortlistEntry& a, const ShortlistEntry& b) { return a.fit.cost < b.fit.cost; });
}

/// The secondary parameters of an effect are free where they gain as much as an effect of its kind has to gain.
void freeSecondaryParameters(const FittedModel& present, std::vector<ShortlistEntry>& entries) {
  forEach(entries.size(), [&](std::size_t i) {
    ShortlistEntry& entry = entries[i];
    if (unknownsOf(*entry.effect, true).size() == unknownsOf(*entry.effect).size()) return;
    Problem finer =
        problemWith(*present.study, *present.evidence, withOneMore(present, *entry.effect, true), present.nuisance);
    const SolveOptions few{.iterations = thresholds::kShortlistIterations, .refine = false};
    entry.fit = solve(*entry.problem, entry.fit.x, few);  // else it is the iterations that gain
    Fit fit = solve(finer, startFrom(finer, *entry.problem, entry.fit.x), few);
    if (entry.fit.cost - fit.cost < leastRoughGain(*entry.effect)) return;
    entry.refined = true;
    entry.problem.emplace(std::move(finer));
    entry.fit = std::move(fit);
  });
  std::ranges::stable_sort(entries, {}, [](const ShortlistEntry& entry) { return entry.fit.cost; });
}

/// The best fit, and of each other effect near it its best fit; at most thresholds::kComparedModels.
std::vector<const ShortlistEntry*> nearBest(const FittedModel& present, const std::vector<ShortlistEntry>& entries) {
  const double least = entries.front().fit.cost;
  const double near = std::max(thresholds::kNearCost, thresholds::kNearGainShare * (present.fit.cost - least));
  std::vector<const ShortlistEntry*> chosen{&entries.front()};
  for (const ShortlistEntry& entry : entries) {
    const auto same = [&](const ShortlistEntry* other) { return other->effect == entry.effect; };
    if (std::ranges::any_of(chosen, same)) continue;
    if (chosen.size() == thresholds::kComparedModels || entry.fit.cost > least + near) break;
    chosen.push_back(&entry);
  }
  return chosen;
}

FittedModel refitEntry(const FittedModel& present, const ShortlistEntry& entry) {
  return refit(*present.study, withOneMore(present, *entry.effect), present.nuisance, *entry.problem, entry.fit, 2);
}

FittedModel entryUnderNoiseOf(const FittedModel& reference, const FittedModel& present, const ShortlistEntry& entry) {
  return refitUnderNoiseOf(withOneMore(present, *entry.effect, entry.refined), present.nuisance, *entry.problem,
                           entry.fit, reference, true);
}

bool hasMoreEvidence(const FittedModel& a, const FittedModel& b) {
  return modelEvidence(a) > modelEvidence(b);
}

/// A model that explains more needs less noise, so all are compared under the noise of the best. A rival that is
/// better even there replaces it if it is better under its own noise as well.
std::vector<FittedModel> rank(const FittedModel& present, const std::vector<const ShortlistEntry*>& entries) {
  std::vector<FittedModel> ranked{refitEntry(present, *entries.front())};
  for (std::size_t i = 1; i < entries.size(); ++i) {
    FittedModel there = entryUnderNoiseOf(ranked.front(), present, *entries[i]);
    if (modelEvidence(there) > modelEvidence(ranked.front()) + thresholds::kRivalLead) {
      FittedModel own = refitEntry(present, *entries[i]);
      if (modelEvidence(own) > modelEvidence(refitUnderNoiseOf(ranked.front(), own, true))) {
        for (FittedModel& other : ranked) other = refitUnderNoiseOf(other, own, true);
        ranked.insert(ranked.begin(), std::move(own));
        continue;
      }
    }
    ranked.push_back(std::move(there));
  }
  std::stable_sort(ranked.begin() + 1, ranked.end(), hasMoreEvidence);
  return ranked;
}

}  // namespace

std::vector<FittedModel> fitCandidates(const FittedModel& present, const Screen& screen,
                                       const std::vector<const twin::EffectInfo*>& only) {
  std::vector<Candidate> candidates = promising(screen, only);
  if (screen.hasRipples())
    for (Candidate& ripple : ripplesOf(present)) candidates.push_back(std::move(ripple));
  std::vector<ShortlistEntry> entries = refinedStarts(screen, candidates);
  if (entries.empty()) return {};
  if (only.empty()) keepFirst(thresholds::kFittedEffects, entries);
  addKnown(present, entries);
  if (present.nuisance == Nuisance::kFree && present.fit.prior > thresholds::kPulledPriorCost)
    addAfresh(present, entries);
  fitAll(present, entries);
  return rank(present, nearBest(present, entries));
}

std::vector<FittedModel> shortlist(const FittedModel& present, const Screen& screen, bool refined) {
  std::vector<ShortlistEntry> entries = refinedStarts(screen, promising(screen, {}, thresholds::kRefinedEffectsRough));
  fitAll(present, entries);
  keepBestStarts(entries);
  keepFirst(thresholds::kFittedEffects, entries);
  if (refined) freeSecondaryParameters(present, entries);
  std::vector<FittedModel> fitted;
  fitted.reserve(entries.size());
  // Good enough to order them: what is tested and added is fitted again, with a Jacobian.
  for (const ShortlistEntry& entry : entries)
    fitted.push_back(refitUnderNoiseOf(withOneMore(present, *entry.effect, entry.refined), present.nuisance,
                                       *entry.problem, entry.fit, present));
  std::ranges::stable_sort(fitted, {}, [](const FittedModel& one) { return one.fit.cost; });
  return fitted;
}

}  // namespace darwinop::gap
