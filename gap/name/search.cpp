#include "gap/name/search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "gap/name/contest.hpp"

namespace darwinop::gap {
namespace {

constexpr double kTooMuchLeft = 0.5;  // of the gap: what took the rest is no name, either
// On kept logs, times the mean error before; chosen, not measured: none of 121 cases of two batteries came near it.
constexpr double kWorse = 1.5;
constexpr double kPlainlyWorse = 2;   // floors, too
constexpr double kPlainMisfit = 1.5;  // cost a residual
constexpr int kFewReplicas = 40;
constexpr int kMostHeld = 2;  // with every number held, more effects are a sign that the numbers are what is off

Settled nothingMissing(const Case& given, Numbers numbers) {
  const Evidence first = evidenceOf(given, baselineOf(given));
  const Problem problem = problemWith(first, {}, numbers);
  Fit start;
  start.x = problem.expected();
  return settle({}, numbers, problem, start, 4);
}

/// What was found on some logs is no finding where others, which no fit has seen, say the opposite.
bool makesKeptWorse(const Case& given, const Naming& naming) {
  const double before = meanErrorOf(given, baselineOf(given), true), after = meanErrorOf(given, naming.model, true);
  return after > kWorse * before && after > before + kPlainlyWorse * naming.floor_rad;  // never without kept logs: NaN
}

}  // namespace

Search::Search(const Case& given, const NameOptions& options, Numbers numbers)
    : given_{given}, options_{options}, suspects_{suspectsOf(given)}, present_{nothingMissing(given, numbers)} {}

void Search::run() {
  const int most =
      present_.numbers == Numbers::kHeld ? std::min(kMostHeld, options_.most_effects) : options_.most_effects;
  bool replaced = false;
  for (;;) {
    const Screen screen{present_, suspects_};
    judge(&screen);
    const bool enough = !present_.effects.empty() && isPractically();
    const bool quiet = misfit_ < kMisfit && screen.probes().front().promise < kPlain * threshold_;
    if (enough || (quiet && mostStrained(present_) < kSuspicious)) return;
    if (static_cast<int>(present_.effects.size()) < most && !isHopeless() && accept(screen)) continue;
    // A rough baseline has another search behind this one, which weighs what stands for what (gap/name/rough.hpp).
    if (replaced || reachedNoise() || isRoughlyKnown(given_) || !replaceOne()) return;
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
  for (std::size_t i = 0; i < effects.size(); ++i) gains_[i] = gainOf(i);
  rivals_.clear();
  threshold_ = other.threshold_;
  judge(nullptr);
}

bool Search::explainsAll() const {
  return leavesNoise() || (!present_.effects.empty() && isPractically());
}

bool Search::leavesNoise() const {
  return misfit_ < kMisfit;
}

bool Search::reachedNoise() const {
  return explainsAll() && mostStrained(present_) < kSuspicious;
}

// The same effect in another simulator, or in a servo, is never the same to the last bit.
bool Search::isPractically() const {
  if (misfit_ > kNearMisfit) return false;
  const double after = gapOf(given_, present_.hypothesis(), false);
  return after < kNearFloors * floorOf(present_) && after < kNearShare * gapOf(given_, baselineOf(given_), false);
}

// A third is no name, either.
bool Search::isHopeless() const {
  return present_.effects.size() > 1 &&
         gapOf(given_, present_.hypothesis(), false) > kTooMuchLeft * gapOf(given_, baselineOf(given_), false);
}

void Search::judge(const Screen* screen) {
  const bool plain = present_.fit.cost > kPlainMisfit * static_cast<double>(present_.fit.residuals.size());
  const Replicas replicas = replicasOf(present_, screen, plain ? kFewReplicas : kReplicas);
  misfit_ = misfitOf(present_, replicas);
  excess_cost_ = present_.fit.cost - present_.fit.prior - replicas.cost_mean;
  if (screen != nullptr) threshold_ = replicas.threshold(options_.alpha);
  say("%.1f standard deviations from what noise explains; %.0f of gain come by chance", misfit_, threshold_);
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
    say("%s explains more than %s", std::string{candidates.front().effects.back().info->id}.c_str(),
        std::string{present_.effects[i].info->id}.c_str());
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
  const bool misleads = !naming.found.empty() && makesKeptWorse(given_, naming);
  naming.verdict = misleads ? Verdict::kUnknown : verdictOf(naming);
  // The strongest first; where rivals are near, the last one is what they contest.
  if (naming.verdict != Verdict::kAmbiguous) std::ranges::stable_sort(naming.found, std::greater{}, &Found::gain);
  // Half a gap that nobody can name is no reason to believe in what took the other half.
  const bool half_left = naming.gap_after_rad > kTooMuchLeft * naming.gap_before_rad;
  if (misleads || (naming.verdict == Verdict::kUnknown && half_left)) {
    for (const Found& one : naming.found)
      if (misleads) naming.doubted.push_back({one.effect, Doubt::kWorsensKept});
    const Settled nothing = nothingMissing(given_, Numbers::kHeld);
    naming.misfit = misfitOf(nothing, replicasOf(nothing, nullptr, kReplicas));
    naming.found.clear();
    naming.rivals.clear();
    naming.strained.clear();
    naming.model = baselineOf(given_);
    naming.gap_after_rad = naming.gap_before_rad;
  }
  return naming;
}

}  // namespace darwinop::gap
