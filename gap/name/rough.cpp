#include "gap/name/rough.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "gap/name/contest.hpp"
#include "gap/name/judge.hpp"
#include "gap/name/supply.hpp"
#include "gap/name/unseen.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr auto kUsual =
    std::to_array<std::string_view>({"coulomb", "viscous", "load_dependent_friction", "encoder_offset"});
constexpr double kUsualGain = 2;        // cost: a number that gains more makes predictions better (Akaike 1974)
constexpr double kLeastGain = 10;       // of a rarer effect: with a dozen to choose from, one gains some by chance
constexpr double kLeastHelp = 0.1;      // of the error on logs that were not fitted: who takes less is no finding
constexpr std::size_t kMostProven = 3;  // candidates a round whose logs are left out one by one
constexpr int kMostRare = 1;            // a round is half a minute, and the second stands on the first
constexpr double kMostLeft = 0.2;       // of the mean error: more, and what was found may stand for something else

/// `from` with these effects only, and every number as it is expected.
Settled afresh(const Effects& effects, const Settled& from) {
  Problem problem = problemWith(*from.evidence, effects, Numbers::kFree);
  Fit fit;
  fit.x = startAfresh(problem, from.problem, from.fit.x);
  return {effects, Numbers::kFree, from.evidence, std::move(problem), std::move(fit), 0};
}

// From one start alone a swing that is out of phase may never come back.
struct Beginning {
  double strength;  // of what has a scale: times the typical value
  double side;      // of what may have either sign
};
constexpr std::array kBeginnings{Beginning{1, 1}, Beginning{0.3, 0}, Beginning{1, -1}};

Settled startedAt(const Beginning& start, Settled fitted) {
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&unknowns[i].what);
    if (parameter == nullptr || std::ranges::find(kUsual, parameter->info->id) == kUsual.end()) continue;
    double& x = fitted.fit.x[static_cast<Eigen::Index>(i)];
    x = unknowns[i].logarithmic ? x + std::log(start.strength) : start.side * x;
  }
  return fitted;
}

/// `effects` with all numbers free; what `from` leaves is noise.
Settled settleRoughly(const Effects& effects, const Settled& from) {
  Evidence bearing{.given = from.evidence->given, .logs = from.evidence->logs, .noise = {}, .unexplained = {}};
  bearing.unexplained = unexplainedBy(*bearing.given, bearing.logs, from.hypothesis());
  return settle(effects, Numbers::kFree, {bearing, from.problem.hypothesis(), from.problem.unknowns()}, from.fit, 2);
}

}  // namespace

RoughSearch::RoughSearch(const Case& given, const NameOptions& options, const Effects& effects, const Settled& from)
    : given_{given},
      options_{options},
      suspects_{suspectsOf(given)},
      present_{settleRoughly(effects, settleRoughly(effects, afresh(effects, from)))} {}

void RoughSearch::run() {
  takeTheUsual();
  for (int i = 0; i < kMostRare && takeNext(); ++i) {
  }
}

void RoughSearch::takeTheUsual() {
  options_.tell("what every servo has some of: friction of three kinds, a zero that is off");
  const std::vector<double> before = errorsUnseen(present_);
  const Settled bare = present_;
  Effects usual = present_.effects;
  for (const std::string_view id : kUsual)
    if (const auto* const effect = twin::findEffect(id); !has(usual, *effect)) usual.push_back({effect});
  double least = std::numeric_limits<double>::infinity();
  for (const Beginning& start : kBeginnings) {
    // The second time bearing with less.
    const Settled first = settleRoughly(usual, startedAt(start, afresh(usual, bare)));
    Settled settled = settleRoughly(usual, first);
    const double error = meanErrorOf(given_, settled.hypothesis(), false);
    if (error < least) least = error, present_ = std::move(settled);
  }
  dropTheNeedless();
  if (!foretold(before, errorsUnseen(present_)).better()) present_ = bare;
}

bool RoughSearch::takeNext() {
  const std::vector<double> errors = errorsUnseen(present_);
  const std::vector<Settled> candidates = heats(present_, Screen{present_, suspects_});
  const Settled* best = nullptr;
  double most = 0;
  std::vector<const Settled*> proven;
  std::size_t tried = 0;
  doubted_.clear();
  for (const Settled& candidate : candidates) {
    const twin::EffectInfo& effect = *candidate.effects.back().info;
    if (present_.fit.cost - candidate.fit.cost < kLeastGain || tried == kMostProven) continue;
    if (isAtItsBound(candidate, effect)) continue;
    if (contradictsVoltage(given_, candidate)) {
      doubted_.push_back({&effect, Doubt::kVoltage});
      continue;
    }
    ++tried;
    const Foretold told = foretold(errors, errorsUnseen(candidate));
    char text[160];
    std::snprintf(text, sizeof text, "%s foretells logs it has not seen %.2f times as well, %.2f to %.2f",
                  std::string{effect.id}.c_str(), std::exp(told.mean), std::exp(told.mean - 2 * told.error),
                  std::exp(told.mean + 2 * told.error));
    options_.tell(text);
    if (!told.better() || told.mean < kLeastHelp) {
      doubted_.push_back({&effect, told.mean < kLeastHelp ? Doubt::kForetellsNothing : Doubt::kUndecided});
      continue;
    }
    proven.push_back(&candidate);
    if (told.mean > most) best = &candidate, most = told.mean;
  }
  std::ranges::stable_sort(doubted_, {}, &Doubted::why);
  if (best == nullptr) return false;
  for (const Settled* const other : proven)
    if (other != best)
      rivals_.push_back({idsOf(other->effects), std::max(0.0, evidenceFor(*best) - evidenceFor(*other)),
                         other->problem.unknowns().size() > best->problem.unknowns().size()});
  present_ = settleRoughly(best->effects, *best);
  dropTheNeedless();
  return true;
}

Settled RoughSearch::less(std::size_t i) const {
  return onNoiseOf(without(present_.effects, i), Numbers::kFree, present_.problem, present_.fit, present_);
}

void RoughSearch::dropTheNeedless() {
  for (std::size_t i = 0; i < present_.effects.size();) {
    const bool usual = std::ranges::find(kUsual, present_.effects[i].info->id) != kUsual.end();
    const Settled rest = less(i);
    if (rest.fit.cost - present_.fit.cost < (usual ? kUsualGain : kLeastGain))
      present_ = settleRoughly(rest.effects, rest);
    else
      ++i;
  }
}

bool RoughSearch::found(const std::vector<std::string>& effects) const {
  return std::ranges::all_of(effects,
                             [&](const std::string& id) { return has(present_.effects, *twin::findEffect(id)); });
}

// Most of the error is gone, or what took some of it may stand for something else.
Verdict RoughSearch::verdictOnRemains(const Naming& naming) const {
  const double before = meanErrorOf(given_, baselineOf(given_), false);
  const bool mostly = meanErrorOf(given_, naming.model, false) < kMostLeft * before;
  return mostly && !naming.found.empty() ? Verdict::kNamed : Verdict::kUnknown;
}

Naming RoughSearch::told() const {
  Naming naming;
  naming.model = present_.hypothesis();
  naming.strained = strainedOf(present_);
  naming.threshold = std::numeric_limits<double>::quiet_NaN();  // chance was not asked: who is rare has to foretell
  naming.doubted = doubted_;
  for (std::size_t i = 0; i < present_.effects.size(); ++i) {
    const twin::EffectInfo& effect = *present_.effects[i].info;
    naming.found.push_back({&effect, estimatesOf(present_, effect, 1), less(i).fit.cost - present_.fit.cost,
                            baselineOf(given_).find(effect.id) != nullptr});
  }
  std::ranges::copy_if(rivals_, std::back_inserter(naming.rivals),
                       [&](const Rival& rival) { return !found(rival.effects); });
  const Settled exactly = onNoiseOfItsOwn(present_);
  naming.misfit = misfitOf(exactly, replicasOf(exactly, nullptr, kReplicas));
  naming.floor_rad = floorOf(exactly);
  naming.gap_before_rad = gapOf(given_, baselineOf(given_), false);
  naming.gap_after_rad = gapOf(given_, naming.model, false);
  naming.remains = naming.misfit > kMisfit;
  naming.verdict = naming.remains ? verdictOnRemains(naming) : verdictOf(naming);
  return naming;
}

}  // namespace darwinop::gap
