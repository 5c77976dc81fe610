#include "gap/name/search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gap/name/contest.hpp"
#include "gap/name/judge.hpp"

namespace darwinop::gap {
namespace {

constexpr double kLeastShare = 0.05;  // of what noise does not explain: less is what any effect happens to explain
constexpr double kTooMuchLeft = 0.5;  // of the gap: what took the rest is no name, either
constexpr double kAtBound = 1e-3;     // of the range
constexpr int kMostHeld = 2;  // with every number held, more effects are a sign that the numbers are what is off

Settled nothingMissing(const Case& given, Numbers numbers) {
  const Evidence first = evidenceOf(given, baselineOf(given));
  const Problem problem = problemWith(first, {}, numbers);
  Fit start;
  start.x = problem.expected();
  return settle({}, numbers, problem, start, 4);
}

template <class... Values>
std::string said(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// An effect that had to be as strong as it can be stands in for something else.
bool isAtItsBound(const Settled& fitted, const twin::EffectInfo& effect) {
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&unknowns[i].what);
    if (parameter == nullptr || parameter->info != &effect || std::isfinite(unknowns[i].sigma)) continue;
    const double low = unknowns[i].toSearch(unknowns[i].low), high = unknowns[i].toSearch(unknowns[i].high);
    const double neutral = unknowns[i].toSearch(effect.parameters[parameter->index].neutral);
    const double x = fitted.fit.x[static_cast<Eigen::Index>(i)], near = kAtBound * (high - low);
    if ((x < low + near && neutral > low + near) || (x > high - near && neutral < high - near)) return true;
  }
  return false;
}

Effects without(Effects effects, std::size_t i) {
  effects.erase(effects.begin() + static_cast<std::ptrdiff_t>(i));
  return effects;
}

}  // namespace

Search::Search(const Case& given, const NameOptions& options, Numbers numbers)
    : given_{given}, options_{options}, suspects_{suspectsOf(given)}, present_{nothingMissing(given, numbers)} {}

void Search::run() {
  const int most =
      present_.numbers == Numbers::kHeld ? std::min(kMostHeld, options_.most_effects) : options_.most_effects;
  bool replaced = false;
  for (int round = 0;; ++round) {
    const Screen screen{present_, suspects_};
    judge(&screen);
    const bool enough = !present_.effects.empty() && isPractically();
    const bool quiet = misfit_ < kMisfit && screen.probes().front().promise < kPlain * threshold_;
    if (enough || (quiet && mostStrained(present_) < kSuspicious)) return;
    if (static_cast<int>(present_.effects.size()) < most && accept(screen)) continue;
    if (replaced || reachedNoise() || !replaceOne()) return;
    replaced = true;
  }
}

void Search::take(const Search& other) {
  take(other, other.present_.effects);
  gains_ = other.gains_, rivals_ = other.rivals_;
}

void Search::take(const Search& other, const Effects& effects) {
  const Settled& found = other.present_;
  present_ = settle(effects, present_.numbers, found.problem, found.fit, 2);
  gains_.assign(effects.size(), 0);
  for (std::size_t i = 0; i < effects.size(); ++i)
    gains_[i] = onNoiseOf(without(effects, i), present_.numbers, present_.problem, present_.fit, present_).fit.cost -
                present_.fit.cost;
  rivals_.clear();
  threshold_ = other.threshold_;
  judge(nullptr);
}

bool Search::reachedNoise() const {
  return (misfit_ < kMisfit || (!present_.effects.empty() && isPractically())) && mostStrained(present_) < kSuspicious;
}

// The same effect in another simulator, or in a servo, is never the same to the last bit.
bool Search::isPractically() const {
  if (misfit_ > kNearMisfit) return false;
  const double after = gapOf(given_, present_.hypothesis(), false);
  return after < kNearFloors * floorOf(present_) && after < kNearShare * gapOf(given_, baselineOf(given_), false);
}

void Search::judge(const Screen* screen) {
  const Replicas replicas = replicasOf(present_, screen);
  misfit_ = misfitOf(present_, replicas);
  excess_cost_ = present_.fit.cost - present_.fit.prior - replicas.cost_mean;
  if (screen != nullptr) threshold_ = replicas.threshold(options_.alpha);
  say(said("%.1f standard deviations from what noise explains; %.0f of gain come by chance", misfit_, threshold_));
}

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
  for (const Settled& best : candidates) {
    const twin::EffectInfo& next = *best.effects.back().info;
    const double gain = onNoiseOf(present_, best).fit.cost - best.fit.cost, needed = neededFor(next);
    say(said("%s would gain %.0f, %.0f needed", std::string{next.id}.c_str(), gain, needed));
    if (gain < needed || isAtItsBound(best, next)) continue;
    // A number that moves as its prior lets it is no finding.
    if (freesAPrior(given_, next) && sigmasOfFreed(given_, best, next) < kSuspicious) continue;
    take(best, gain, candidates, needed);
    return true;
  }
  return false;
}

void Search::take(const Settled& best, double gain, const std::vector<Settled>& candidates, double needed) {
  rivals_.clear();
  for (const Settled& other : candidates) {
    if (&other == &best) continue;
    if (std::ranges::find(seconds_, other.effects.back().info) == seconds_.end())
      seconds_.push_back(other.effects.back().info);
    if (neededFor(*other.effects.back().info) <= needed)
      rivals_.push_back({idsOf(other.effects), evidenceFor(best) - evidenceFor(other)});
  }
  gains_.push_back(gain);
  present_ = best.fit.slopes.size() > 0 ? best : settle(best.effects, best.numbers, best.problem, best.fit, 1);
  refine();
  dropTheNeedless();
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
    if (gain < (freesAPrior(given_, *present_.effects[i].info) ? kStrainGain : threshold_)) {
      say(said("%s is no longer needed", std::string{present_.effects[i].info->id}.c_str()));
      present_ = settle(less.effects, less.numbers, less.problem, less.fit, 2);
      gains_.erase(gains_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      gains_[i++] = gain;
    }
  }
}

// Each effect but the last was chosen while something else was missing, too.
bool Search::replaceOne() {
  for (std::size_t i = 0; i + 1 < present_.effects.size(); ++i) {
    const Settled less = settle(without(present_.effects, i), present_.numbers, present_.problem, present_.fit, 1);
    const Screen screen{less, suspects_};
    const std::vector<Settled> candidates = contest(less, screen);
    if (candidates.empty() || candidates.front().effects.back().info == present_.effects[i].info) continue;
    const double gain = onNoiseOf(present_, candidates.front()).fit.cost - candidates.front().fit.cost;
    if (gain < threshold_) continue;
    say(said("%s explains more than %s", std::string{candidates.front().effects.back().info->id}.c_str(),
             std::string{present_.effects[i].info->id}.c_str()));
    gains_.erase(gains_.begin() + static_cast<std::ptrdiff_t>(i));
    take(candidates.front(), gain, candidates, threshold_);
    return true;
  }
  return false;
}

Naming Search::told() const {
  Naming naming;
  naming.threshold = threshold_;
  naming.misfit = misfit_;
  naming.model = withoutUnseen(present_);
  naming.rivals = rivals_;
  naming.strained = strainedOf(present_);
  const Settled wide = withFreeNumbers(present_);
  const double size = present_.fit.cost - present_.fit.prior, excess = size / (size - excess_cost_);
  for (std::size_t i = 0; i < present_.effects.size(); ++i)
    naming.found.push_back({present_.effects[i].info, estimatesOf(wide, *present_.effects[i].info, excess), gains_[i],
                            baselineOf(given_).find(present_.effects[i].info->id) != nullptr});
  naming.gap_before_rad = gapOf(given_, baselineOf(given_), false);
  naming.gap_after_rad = gapOf(given_, naming.model, false);
  naming.floor_rad = floorOf(present_);
  naming.verdict = verdictOf(naming);
  // Half a gap that nobody can name is no reason to believe in what took the other half.
  if (naming.verdict == Verdict::kUnknown && naming.gap_after_rad > kTooMuchLeft * naming.gap_before_rad) {
    naming.found.clear();
    naming.rivals.clear();
    naming.strained.clear();
    naming.model = baselineOf(given_);
    naming.gap_after_rad = naming.gap_before_rad;
  }
  return naming;
}

}  // namespace darwinop::gap
