// Which of several candidates a search believes, and what it does about those it believed before.
#include <algorithm>
#include <cmath>

#include "gap/name/contest.hpp"
#include "gap/name/search.hpp"
#include "gap/name/unseen.hpp"
#include "gap/sim/freed.hpp"

namespace darwinop::gap {
namespace {

constexpr double kLeastShare = 0.05;  // of what noise does not explain: less is what any effect happens to explain
constexpr double kNearlyAll = 0.8;    // of the same
constexpr double kPlainlyWrong = 2;   // cost a residual, beyond what noise explains
constexpr double kInside = 1.5;       // sigma: where one number is off and all others are right, it is named beyond

}  // namespace

bool Search::accept(const Screen& screen) {
  // Where noise explains the rest, a number that is pulled out of its prior comes first: what it stands for may be all.
  if (mostStrained(present_) > kSuspicious && misfit_ < kMisfit) {
    std::vector<const twin::EffectInfo*> freed;
    for (const auto* effect : suspects_)
      if (freesAPrior(given_, *effect) && !has(present_.effects, *effect)) freed.push_back(effect);
    if (!freed.empty() && acceptOneOf(contest(present_, screen, freed))) return true;
  }
  return acceptOneOf(contest(present_, screen));
}

bool Search::acceptOneOf(const std::vector<Settled>& candidates) {
  std::vector<Settled> again;  // the present effects, on the noise of each candidate
  for (const Settled& best : candidates) {
    const twin::EffectInfo& next = *best.effects.back().info;
    again.push_back(onNoiseOf(present_, best));
    const double gain = again.back().fit.cost - best.fit.cost, needed = neededFor(next);
    say("%s would gain %.0f, %.0f needed", std::string{next.id}.c_str(), gain, needed);
    if (gain < needed || (isAtItsBound(best, next) && gain < kNearlyAll * excess_cost_)) continue;
    if (isNextToNothing(best, next)) continue;
    // A number that moves as its prior lets it is no finding. Where it explains most with every other number held, what
    // explains less is none, either.
    const bool held = present_.numbers == Numbers::kHeld;
    if (freesAPrior(given_, next) && sigmasOfFreed(given_, best.hypothesis(), next) < (held ? kInside : kSuspicious)) {
      if (held && &best == &candidates.front()) return false;
      continue;
    }
    if (!isProven(best, again.back(), gain)) continue;
    take(best, gain, candidates, needed);
    return true;
  }
  return std::ranges::any_of(again, [&](const Settled& same) { return improve(same); });
}

// On other noise the same effects may have found their way out of where they were stuck.
bool Search::improve(const Settled& same) {
  if (present_.effects.empty() || onNoiseOf(same, present_).fit.cost > present_.fit.cost - threshold_) return false;
  Settled better = settle(same.effects, same.numbers, same.problem, same.fit, 2);
  const double gain = present_.total - better.total;
  if (gain < threshold_) return false;
  say("the same effects explain %.0f more from another start", gain);
  present_ = std::move(better);
  for (Rival& rival : rivals_) rival.behind += gain;
  dropTheNeedless();
  gains_.back() = gainOf(present_.effects.size() - 1);
  if (present_.effects.size() > 1 && gains_.back() < leastGainOf(*present_.effects.back().info)) {
    gains_.pop_back();
    present_ = settle(without(present_.effects, gains_.size()), present_.numbers, present_.problem, present_.fit, 2);
  }
  return true;
}

double Search::gainOf(std::size_t i) const {
  return onNoiseOf(without(present_.effects, i), present_.numbers, present_.problem, present_.fit, present_).fit.cost -
         present_.fit.cost;
}

// Under a model that is plainly wrong still, each further effect fits something. It has to foretell, too.
bool Search::isProven(const Settled& best, const Settled& less, double gain) const {
  if (present_.effects.empty() || excess_cost_ - gain < kPlainlyWrong * static_cast<double>(best.fit.residuals.size()))
    return true;
  const Foretold told = foretold(less, best);
  say("foretells logs it has not seen %.2f times as well, %.2f to %.2f", std::exp(told.mean),
      std::exp(told.mean - 2 * told.error), std::exp(told.mean + 2 * told.error));
  return told.better();
}

void Search::take(const Settled& best, double gain, const std::vector<Settled>& candidates, double needed) {
  rivals_.clear();
  for (const Settled& other : candidates) {
    if (&other == &best) continue;
    if (std::ranges::find(seconds_, other.effects.back().info) == seconds_.end())
      seconds_.push_back(other.effects.back().info);
    if (neededFor(*other.effects.back().info) > needed) continue;
    double behind = evidenceFor(best) - evidenceFor(other);
    // Who has to bend a number of the baseline, where the best need not, leaves something to be named.
    if (mostStrained(other) > kSuspicious && mostStrained(best) < kSuspicious) behind = std::max(behind, kRivalry);
    rivals_.push_back({idsOf(other.effects), behind, other.problem.unknowns().size() > best.problem.unknowns().size()});
  }
  gains_.push_back(gain);
  present_ = best.fit.slopes.size() > 0 ? best : settle(best.effects, best.numbers, best.problem, best.fit, 1);
  refine();
  dropTheNeedless();
  while (simplifyOne()) {
  }
}

double Search::neededFor(const twin::EffectInfo& effect) const {
  if (freesAPrior(given_, effect) && mostStrained(present_) > kSuspicious) return kStrainGain;
  return std::max((misfit_ < kMisfit ? kPlain : 1) * threshold_, kLeastShare * excess_cost_);
}

// What is left may be the shape of the effect just found, before it is another effect.
void Search::refine() {
  const Chosen& last = present_.effects.back();
  if (unknownsOf(*last.info, true).size() == unknownsOf(*last.info).size()) return;
  Effects finer = present_.effects;
  finer.back().refined = true;
  const Settled refined = onNoiseOf(finer, present_.numbers, present_.problem, present_.fit, present_);
  if (present_.fit.cost - refined.fit.cost > threshold_)
    present_ = settle(finer, refined.numbers, refined.problem, refined.fit, 2);
}

// An effect that stood in for one found later.
void Search::dropTheNeedless() {
  for (std::size_t i = 0; present_.effects.size() > 1 && i + 1 < present_.effects.size();) {
    const Settled less =
        onNoiseOf(without(present_.effects, i), present_.numbers, present_.problem, present_.fit, present_);
    const double gain = less.fit.cost - present_.fit.cost;
    if (gain < leastGainOf(*present_.effects[i].info)) {
      say("%s is no longer needed", std::string{present_.effects[i].info->id}.c_str());
      present_ = settle(less.effects, less.numbers, less.problem, less.fit, 2);
      gains_.erase(gains_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      gains_[i++] = gain;
    }
  }
}

// What was chosen while something else was missing may have more numbers than it needs: a gear that rubs one way as
// much as the other is no gear that knows directions.
bool Search::simplifyOne() {
  for (std::size_t i = 0; i + 1 < present_.effects.size(); ++i) {
    const twin::EffectInfo& rich = *present_.effects[i].info;
    std::vector<const twin::EffectInfo*> simpler;
    for (const auto* effect : suspects_)
      if (std::ranges::find(rich.confused_with, effect->id) != rich.confused_with.end() &&
          !has(present_.effects, *effect) && !freesAPrior(given_, *effect) &&
          unknownsOf(*effect).size() < unknownsOf(rich).size())
        simpler.push_back(effect);
    if (simpler.empty()) continue;
    const Settled less =
        onNoiseOf(without(present_.effects, i), present_.numbers, present_.problem, present_.fit, present_, true);
    const std::vector<Settled> candidates = contest(less, Screen{less, simpler}, simpler);
    if (candidates.empty()) continue;
    const Settled& plain = candidates.front();
    const twin::EffectInfo& info = *plain.effects.back().info;
    const Settled here = onNoiseOf(plain, present_, true), there = onNoiseOf(present_, plain, true);
    const double gain = less.fit.cost - here.fit.cost;
    const bool ahead = evidenceFor(here) > evidenceFor(present_) && evidenceFor(plain) > evidenceFor(there);
    if (!ahead || gain < neededFor(info) || isAtItsBound(plain, info) || isNextToNothing(plain, info)) continue;
    say("%s explains as much as %s", std::string{info.id}.c_str(), std::string{rich.id}.c_str());
    replace(i, plain, gain);
    return true;
  }
  return false;
}

void Search::replace(std::size_t i, const Settled& plain, double gain) {
  const twin::EffectInfo& rich = *present_.effects[i].info;
  const std::string was{rich.id}, is{plain.effects.back().info->id};
  for (Rival& rival : rivals_) {
    if (std::ranges::find(rival.effects, is) != rival.effects.end()) rival.effects.clear();
    std::ranges::replace(rival.effects, was, is);
  }
  std::erase_if(rivals_, [](const Rival& rival) { return rival.effects.empty(); });
  Effects effects = present_.effects;
  effects[i] = plain.effects.back();
  present_ = settle(effects, plain.numbers, plain.problem, plain.fit, 1);
  gains_[i] = gain;
  std::erase(suspects_, &rich);  // or the two could take turns for ever
}

}  // namespace darwinop::gap
