#include "gap/name/contest.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "gap/name/ripple.hpp"
#include "gap/sim/parallel.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kMostSharpened = 10, kMostInHeats = 16, kStarts = 3, kMostFitted = 6, kMostRivals = 5;
constexpr double kNear = 0.15;    // of the best gain: who is that close is compared on the best one's noise
constexpr double kNearCost = 60;  // or that close in cost
constexpr double kDragged = 15;   // cost of the priors: the numbers have been pulled away, so try from where they were
constexpr double kEnoughGain =
    2;  // evidence by which a rival has to lead on the best one's noise to be looked at itself

struct Entrant {
  const twin::EffectInfo* effect = nullptr;
  Eigen::VectorXd start;
  double promise = 0;
  std::optional<Problem> problem = std::nullopt;
  Fit fit = {};
};

Effects withOneMore(const Settled& present, const twin::EffectInfo& effect) {
  Effects effects = present.effects;
  effects.push_back({&effect});
  return effects;
}

std::vector<Probe> promising(const Screen& screen, const std::vector<const twin::EffectInfo*>& only,
                             std::size_t most = kMostSharpened) {
  std::vector<Probe> chosen;
  std::map<const twin::EffectInfo*, std::size_t> starts;
  for (const Probe& probe : screen.probes()) {
    if (!only.empty() && std::find(only.begin(), only.end(), probe.effect) == only.end()) continue;
    const bool wanted = starts.contains(probe.effect) || starts.size() < most;
    if (wanted && starts[probe.effect]++ < kStarts) chosen.push_back(probe);
  }
  return chosen;
}

/// Of ripples the count decides, and a fit cannot cross from one to the next.
bool startAlike(const Probe& one, const Probe& other) {
  return one.effect == other.effect && (one.effect->id != "cogging" || std::abs(one.values[1] - other.values[1]) < 1);
}

/// The best starts of each effect that differ, best first.
std::vector<Entrant> sharpest(const Screen& screen, const std::vector<Probe>& probes) {
  std::vector<Sharpened> sharpened(probes.size());
  forEach(probes.size(), [&](std::size_t i) { sharpened[i] = screen.sharpened(probes[i]); });
  std::stable_sort(sharpened.begin(), sharpened.end(),
                   [](const Sharpened& a, const Sharpened& b) { return a.probe.promise > b.probe.promise; });
  std::vector<Entrant> best;
  std::vector<const Probe*> seen;
  for (Sharpened& one : sharpened) {
    const auto alike = [&](const Probe* other) { return startAlike(*other, one.probe); };
    if (std::any_of(seen.begin(), seen.end(), alike)) continue;
    seen.push_back(&one.probe);
    best.push_back({one.probe.effect, std::move(one.x), one.probe.promise});
  }
  return best;
}

/// The first so many effects, with all of their starts.
void keepFirst(std::size_t most, std::vector<Entrant>& entrants) {
  std::set<const twin::EffectInfo*> kept;
  std::erase_if(entrants, [&](const Entrant& entrant) {
    if (kept.size() < most) kept.insert(entrant.effect);
    return !kept.contains(entrant.effect);
  });
}

/// The best start of each effect, of entrants that are fitted.
void keepBestStarts(std::vector<Entrant>& entrants) {
  std::set<const twin::EffectInfo*> kept;
  std::erase_if(entrants, [&](const Entrant& entrant) { return !kept.insert(entrant.effect).second; });
}

/// What the present model moves within a prior, an effect may begin from.
void addKnown(const Settled& present, std::vector<Entrant>& entrants) {
  std::vector<Entrant> known;
  for (const Entrant& entrant : entrants) {
    const auto own = unknownsOf(*entrant.effect);
    const bool all = !own.empty() && std::all_of(own.begin(), own.end(), [&](const Unknown& one) {
      return std::any_of(present.problem.unknowns().begin(), present.problem.unknowns().end(),
                         [&](const Unknown& other) { return other.name == one.name; });
    });
    if (!all) continue;
    const Problem problem = problemWith(*present.evidence, withOneMore(present, *entrant.effect), present.numbers);
    known.push_back({entrant.effect, startFrom(problem, present.problem, present.fit.x), entrant.promise});
  }
  entrants.insert(entrants.end(), known.begin(), known.end());
}

/// The same starts, with the numbers where they are expected.
void addAfresh(const Settled& present, std::vector<Entrant>& entrants) {
  for (std::size_t i = 0, count = entrants.size(); i < count; ++i) {
    Entrant afresh = entrants[i];
    const Problem problem = problemWith(*present.evidence, withOneMore(present, *afresh.effect), present.numbers);
    const Eigen::VectorXd expected = problem.expected();
    for (std::size_t k = 0; k < problem.unknowns().size(); ++k)
      if (std::isfinite(problem.unknowns()[k].sigma))
        afresh.start[static_cast<Eigen::Index>(k)] = expected[static_cast<Eigen::Index>(k)];
    entrants.push_back(std::move(afresh));
  }
}

void fitAll(const Settled& present, std::vector<Entrant>& entrants) {
  forEach(entrants.size(), [&](std::size_t i) {
    Entrant& entrant = entrants[i];
    entrant.problem.emplace(problemWith(*present.evidence, withOneMore(present, *entrant.effect), present.numbers));
    entrant.fit = solve(*entrant.problem, entrant.start, {.iterations = 6, .refine = false});
  });
  std::stable_sort(entrants.begin(), entrants.end(),
                   [](const Entrant& a, const Entrant& b) { return a.fit.cost < b.fit.cost; });
}

}  // namespace

std::vector<Settled> contest(const Settled& present, const Screen& screen,
                             const std::vector<const twin::EffectInfo*>& only) {
  std::vector<Probe> probes = promising(screen, only);
  if (screen.suspects("cogging"))
    for (Probe& ripple : ripplesOf(present)) probes.push_back(std::move(ripple));
  std::vector<Entrant> entrants = sharpest(screen, probes);
  if (entrants.empty()) return {};
  if (only.empty()) keepFirst(kMostFitted, entrants);
  addKnown(present, entrants);
  if (present.numbers == Numbers::kFree && present.fit.prior > kDragged) addAfresh(present, entrants);
  fitAll(present, entrants);

  const auto settled = [&](const Entrant& entrant) {
    return settle(withOneMore(present, *entrant.effect), present.numbers, *entrant.problem, entrant.fit, 2);
  };
  const double least = entrants.front().fit.cost, near = std::max(kNearCost, kNear * (present.fit.cost - least));
  std::vector<Settled> ranked{settled(entrants.front())};
  std::vector<const Entrant*> rivals;
  for (const Entrant& entrant : entrants) {
    const auto same = [&](const Entrant* other) { return other->effect == entrant.effect; };
    if (entrant.effect == entrants.front().effect || std::any_of(rivals.begin(), rivals.end(), same)) continue;
    if (rivals.size() + 1 == kMostRivals || entrant.fit.cost > least + near) break;
    rivals.push_back(&entrant);
  }
  // Who explains most pays least for noise; all are judged by its noise, sample by sample.
  for (const Entrant* rival : rivals) {
    Settled there = onNoiseOf(withOneMore(present, *rival->effect), present.numbers, *rival->problem, rival->fit,
                              ranked.front(), true);
    if (evidenceFor(there) > evidenceFor(ranked.front()) + kEnoughGain) {
      Settled own = settled(*rival);
      if (evidenceFor(own) > evidenceFor(onNoiseOf(ranked.front(), own, true))) {  // ahead on the noise of either
        for (Settled& other : ranked) other = onNoiseOf(other, own, true);
        ranked.insert(ranked.begin(), std::move(own));
        continue;
      }
    }
    ranked.push_back(std::move(there));
  }
  std::stable_sort(ranked.begin() + 1, ranked.end(),
                   [](const Settled& a, const Settled& b) { return evidenceFor(a) > evidenceFor(b); });
  return ranked;
}

std::vector<Settled> heats(const Settled& present, const Screen& screen) {
  std::vector<Entrant> entrants = sharpest(screen, promising(screen, {}, kMostInHeats));
  fitAll(present, entrants);
  keepBestStarts(entrants);
  keepFirst(kMostFitted, entrants);
  std::vector<Settled> fitted;
  fitted.reserve(entrants.size());
  for (const Entrant& entrant : entrants)
    fitted.push_back(onNoiseOf(withOneMore(present, *entrant.effect), present.numbers, *entrant.problem, entrant.fit,
                               present, true));
  std::stable_sort(fitted.begin(), fitted.end(),
                   [](const Settled& a, const Settled& b) { return evidenceFor(a) > evidenceFor(b); });
  return fitted;
}

}  // namespace darwinop::gap
