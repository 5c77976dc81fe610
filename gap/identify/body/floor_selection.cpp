#include "gap/identify/body/floor_selection.hpp"

#include <algorithm>
#include <cmath>

#include "gap/identify/body/floor_agreement.hpp"
#include "gap/identify/body/floor_candidates.hpp"
#include "gap/identify/body/floor_search.hpp"
#include "gap/identify/body/stance_selection.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/localize/body/floor_rows.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

FloorSet setOf(const std::vector<FoundFloor>& found) {
  FloorSet out;
  for (const FoundFloor& one : found) out.push_back(one.placed);
  return out;
}

/// One selection, from the model as it is to the last name that earns its place.
class FloorSearch {
 public:
  FloorSearch(const BodyCase& given, const FloorModel& about, const std::vector<Joint>& ignored, std::size_t other_rows)
      : given_{given},
        ignored_{ignored},
        logs_{floorLogs(given, false)},
        imu_{given.joints.model},
        stance_{given, imu_, about},
        effects_{floorCandidates(given, about)},
        of_gyro_{stance_.best(*effects_)},
        about_{withGyro(about)},
        residuals_{given, logs_, imu_, about_, ignored},
        open_from_{sigmasOfChance(thresholds::kFalseDiscoveries / static_cast<double>(other_rows + kFloorSignals))},
        evaluator_{residuals_, about_},
        unseen_{given, imu_, ignored} {
    out_.effects = effects_;
    out_.rows = rowsWith(residuals_, {}, about.imu), out_.rows_after = rowsWith(residuals_, {}, about_.imu);
    excess_of_none_ = excessOf({});
  }

  FloorSelection run() {
    while (isOpen(out_.rows_after) && out_.found.size() < thresholds::kMostFloorEffects) {
      const Step step = addNext();
      if (step == Step::kFound) refine();
      if (step == Step::kNothing || out_.tried.size() >= thresholds::kRefusedOfLimb) break;
    }
    if (of_gyro_) out_.found.insert(out_.found.begin(), *of_gyro_);
    return std::move(out_);
  }

 private:
  /// The model with the effect that stance feet show.
  [[nodiscard]] FloorModel withGyro(FloorModel model) const {
    if (of_gyro_) of_gyro_->placed.effect->apply(model, of_gyro_->placed.values);
    return model;
  }
  std::vector<BodyRow> rowsWith(const FloorResiduals& residuals, const FloorSet& set) {
    return rowsWith(residuals, set, evaluator_.modelOf(set).imu);
  }
  std::vector<BodyRow> rowsWith(const FloorResiduals& residuals, const FloorSet& set, const ImuDeviation& imu) {
    std::vector<BodyRow> rows = floorRows(given_, residuals, evaluator_.tracesOf(set), imu);
    for (BodyRow& row : rows) row.open = row.significance > open_from_;
    return rows;
  }
  static bool isOpenRow(const BodyRow& row) { return row.open; }
  static bool isOpen(const std::vector<BodyRow>& rows) { return std::ranges::any_of(rows, isOpenRow); }
  double costWith(const FloorSet& set) { return costOf(set, evaluator_.residuals({set}).front()); }
  /// Cost beyond that of noise.
  double excessOf(const FloorSet& set) {
    return costWith(set) - static_cast<double>(evaluator_.size()) * thresholds::kFloorCostOfNoise;
  }

  enum class Step : std::uint8_t { kFound, kRefused, kNothing };

  /// The best of all further names that was not refused yet.
  Step addNext() {
    const FloorSet now = setOf(out_.found);
    const double cost = costWith(now);
    std::vector<const FloorEffect*> allowed;
    for (const FloorEffect& effect : *effects_)
      if (std::ranges::find(out_.tried, &effect, &PlacedFloor::effect) == out_.tried.end()) allowed.push_back(&effect);
    std::vector<FloorCandidate> candidates = nextFloorEffects(evaluator_, allowed, now, cost);
    // What stance feet show of a gyroscope needs no contact to be right.
    std::erase_if(candidates, [&](const FloorCandidate& one) {
      const FloorSet& set = one.fit.set;
      return set.back().effect->is_of_sensor && (of_gyro_ || stance_.refutes(evaluator_.modelOf(set).imu));
    });
    if (candidates.empty()) return Step::kNothing;
    const FloorCandidate& best = candidates.front();
    const double least =
        std::max(thresholds::kFloorShare * excessOf(now), thresholds::kMechanicsRemainder * excess_of_none_);
    if (!(earnsName(best) && cost - best.fit.cost > least)) {
      // More likely than nothing, and no name: it leaves too much, or engines may have this number themselves.
      if (isLikely(best.evidence)) out_.tried.push_back(best.fit.set.back());
      return Step::kNothing;
    }
    if (isOfLimb(*best.fit.set.back().effect, ignored_)) {
      // What the limb does explains more than any other name would.
      out_.tried.push_back(best.fit.set.back());
      return Step::kNothing;
    }
    if (isContradicted(now, best.fit.set)) {
      out_.tried.push_back(best.fit.set.back());
      return Step::kRefused;
    }
    std::vector<PlacedFloor> rivals;
    for (std::size_t i = 1; i < candidates.size(); ++i)
      if (earnsName(candidates[i]) && best.evidence - candidates[i].evidence < thresholds::kRivalEvidence)
        rivals.push_back(candidates[i].fit.set.back());
    out_.found.push_back({.placed = {}, .sigmas = {}, .rivals = std::move(rivals)});
    use(best.fit);
    return Step::kFound;
  }
  static bool isLikely(double evidence) { return evidence > -2 * std::log(thresholds::kMechanicalChance); }
  static bool earnsName(const FloorCandidate& one) { return isLikely(one.name_evidence); }

  /// A log, for fits or held out, contradicts what the second set has beyond the first: under the noise of the second,
  /// whose chaos and engines may be others. How much is left takes no name away: engines differ, and a walk forgets its
  /// start slowly.
  bool isContradicted(const FloorSet& without, const FloorSet& with) {
    const FloorModel before = evaluator_.modelOf(without), after = evaluator_.modelOf(with);
    about_next_ = std::make_unique<FloorResiduals>(given_, logs_, imu_, after, ignored_);
    return refute(gainsOf(*about_next_, evaluator_.tracesOf(without), before.imu, after.imu)) ||
           unseen_.refute(before, after);
  }

  /// What chaos has widened stays as wide: later fits begin in one valley of it.
  void use(const FloorFit& fit) {
    for (std::size_t i = 0; i < out_.found.size(); ++i) {
      std::vector<double> sigmas = fit.sigmas[i];
      for (std::size_t k = 0; k < out_.found[i].sigmas.size(); ++k)
        sigmas[k] = std::max(sigmas[k], out_.found[i].sigmas[k]);
      out_.found[i].placed = fit.set[i], out_.found[i].sigmas = std::move(sigmas);
    }
  }

  /// Under the noise of what was found: its repeats and engines show its chaos. What is left may be that chaos: a
  /// further name has to explain more.
  void refine() {
    about_found_ = std::move(about_next_);
    evaluator_.useNoiseOf(*about_found_);
    FloorSet found = setOf(out_.found), without = found;
    without.pop_back();
    if (const FloorFit again = refined(evaluator_, found); !isContradicted(without, again.set))
      use(again), found = again.set;
    out_.rows_after = rowsWith(residuals_, found);
    if (!isOpen(out_.rows_after)) return;
    out_.rows_after = rowsWith(*about_found_, found);
    excess_of_none_ = excessOf({});
  }

  const BodyCase& given_;
  const std::vector<Joint>& ignored_;
  const std::vector<std::size_t> logs_;
  const MovingImu imu_;
  const StanceSelection stance_;
  const std::shared_ptr<const std::vector<FloorEffect>> effects_;
  std::optional<FoundFloor> of_gyro_;  // found first: by the kinematics of feet
  const FloorModel about_;
  const FloorResiduals residuals_;
  std::unique_ptr<FloorResiduals> about_next_;   // noise of the candidate that was judged last
  std::unique_ptr<FloorResiduals> about_found_;  // noise of what was found
  const double open_from_;
  FloorEvaluator evaluator_;
  const UnseenFloor unseen_;
  FloorSelection out_;
  double excess_of_none_ = 0;
};

}  // namespace

bool isOfLimb(const FloorEffect& effect, const std::vector<Joint>& unexplained) {
  return effect.is_of_load && !unexplained.empty();
}

FloorSelection identifyFloor(const BodyCase& given, const FloorModel& about, const std::vector<Joint>& ignored,
                             std::size_t other_rows) {
  if (!canSimulateFloor(given)) return {};
  return FloorSearch{given, about, ignored, other_rows}.run();
}

FloorSelection identifyMovingGyro(const BodyCase& given, const FloorModel& about) {
  const auto effects = floorCandidates(given, about);
  const MovingImu imu{given.joints.model};
  FloorSelection out{.effects = effects, .found = {}, .rows = {}, .rows_after = {}, .tried = {}};
  if (std::optional<FoundFloor> found = StanceSelection{given, imu, about}.best(*effects))
    out.found.push_back(std::move(*found));
  return out;
}

}  // namespace darwinop::gap
