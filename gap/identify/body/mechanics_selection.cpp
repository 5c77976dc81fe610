#include "gap/identify/body/mechanics_selection.hpp"

#include <algorithm>
#include <cmath>

#include "gap/identify/body/controller_selection.hpp"
#include "gap/identify/body/declared_numbers.hpp"
#include "gap/identify/body/held_out_motion.hpp"
#include "gap/identify/body/log_agreement.hpp"
#include "gap/identify/body/next_mechanics.hpp"
#include "gap/identify/body/refit_mechanics.hpp"
#include "gap/identify/body/unexplained_mechanics.hpp"
#include "gap/localize/body/close_by_numbers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

bool contains(const std::vector<PlacedMechanics>& list, const PlacedMechanics& placed) {
  return std::ranges::any_of(list, [&](const auto& one) { return one.sameName(placed); });
}

bool isIn(std::size_t limb, const std::vector<std::size_t>& limbs) {
  return std::ranges::find(limbs, limb) != limbs.end();
}

/// The best acceptable candidate is added until there is none. A candidate that logs refuse leaves its place to the
/// next; a limb without an acceptable one is closed until something in it changes.
class ForwardSelection {
 public:
  ForwardSelection(ClampedRobot& robot, const BodyTable& table)
      : robot_{robot}, open_from_{table.open_from}, before_{excessOf(robot, robot.baseline())} {}

  void run(MechanicsSelection& out);
  void renewRows(MechanicsSelection& out, const std::vector<std::size_t>& limbs);

 private:
  void addAll(MechanicsSelection& out);
  /// False: there is no acceptable candidate.
  bool step(MechanicsSelection& out);
  bool add(MechanicsSelection& out, FoundMechanics one);
  [[nodiscard]] double needed(const PlacedMechanics& placed) const;
  [[nodiscard]] bool isAcceptable(const MechanicsEntry& entry) const;
  [[nodiscard]] FoundMechanics foundOf(const MechanicsEntry& best, const std::vector<MechanicsEntry>& entries) const;
  /// The number of the model that this effect is would explain as much within its prior.
  [[nodiscard]] bool isNumber(const MechanicsEntry& entry) const;

  ClampedRobot& robot_;
  const double open_from_;
  const std::vector<double> before_;      // excess of each limb
  std::vector<double> excess_;            // the same, with what is found
  std::vector<PlacedMechanics> numbers_;  // effects that are numbers of the model within their priors
  std::vector<PlacedMechanics> refused_;
  std::vector<std::size_t> closed_;  // limbs without an acceptable candidate
};

// Limbs whose residuals are new may be off within their priors.
void ForwardSelection::renewRows(MechanicsSelection& out, const std::vector<std::size_t>& limbs) {
  const BodyHypothesis now = with(robot_, effectsOf(out.found));
  for (const PlacedMechanics& one : numbers_)
    if (isInOneOf(robot_, one, limbs)) moveNumbers(robot_, one, now);
  closeByNumbers(robot_, limbs, now, open_from_);
  out.rows = mechanicsRows(robot_, now);
  for (BodyRow& row : out.rows) row.open = row.significance > open_from_;
  std::erase_if(closed_, [&](std::size_t limb) { return isIn(limb, limbs); });
}

double ForwardSelection::needed(const PlacedMechanics& placed) const {
  const std::vector<std::size_t> limbs = limbsOf(robot_, {placed});
  return std::max({-2 * std::log(thresholds::kMechanicalChance), thresholds::kMechanicsShare * sumOver(limbs, excess_),
                   thresholds::kMechanicsRemainder * sumOver(limbs, before_)});
}

bool ForwardSelection::isNumber(const MechanicsEntry& entry) const {
  return entry.evidence - std::max(0.0, entry.gain - priorCost(robot_, entry.placed())) < needed(entry.placed());
}

bool ForwardSelection::isAcceptable(const MechanicsEntry& entry) const {
  const PlacedMechanics& placed = entry.placed();
  return entry.evidence >= needed(placed) && !contains(refused_, placed);
}

bool ForwardSelection::add(MechanicsSelection& out, FoundMechanics one) {
  const std::vector<std::size_t> limbs = limbsOf(robot_, {one.placed});
  const std::vector<FoundMechanics> without = out.found;
  const BodyHypothesis before = with(robot_, effectsOf(without));
  const double unseen = heldOutError(robot_, before);
  out.found.push_back(std::move(one));
  refitMechanics(robot_, out.found);
  const BodyHypothesis after = with(robot_, effectsOf(out.found));
  renewRows(out, limbs);  // both are judged with the numbers that the fits left
  const bool holds = !anyLogRefutes(robot_, limbs, before, after) && holdsUnseen(unseen, heldOutError(robot_, after));
  if (!holds) {
    refused_.push_back(out.found.back().placed);
    out.tried.push_back(out.found.back().placed);
    out.found = without;
    robot_.renew(limbs, before);
    renewRows(out, limbs);
  }
  return holds;
}

bool ForwardSelection::step(MechanicsSelection& out) {
  std::vector<std::size_t> open = openLimbs(robot_, out.rows, open_from_);
  std::erase_if(open, [&](std::size_t limb) { return isIn(limb, closed_); });
  if (open.empty()) return false;
  excess_ = excessOf(robot_, with(robot_, effectsOf(out.found)));
  std::vector<MechanicsEntry> entries = nextMechanics(robot_, out.found, open, excess_, refused_);
  const auto is_of_all = [](const MechanicsEntry& entry) { return entry.placed().joints.size() == kJoints; };
  const bool are_of_all = std::ranges::all_of(entries, is_of_all);
  std::size_t refused_of_all = 0;
  std::vector<std::size_t> refused_in(robot_.limbs().size()), changed;
  const auto dropLimbs = [&](const auto& is_done) {
    std::erase_if(entries,
                  [&](const auto& entry) { return std::ranges::any_of(limbsOf(robot_, {entry.placed()}), is_done); });
  };
  bool has_added = false;
  while (!has_added) {
    const auto best = std::ranges::find_if(entries, [&](const auto& entry) { return isAcceptable(entry); });
    if (best == entries.end()) break;
    const PlacedMechanics placed = best->placed();
    const std::vector<std::size_t> limbs = limbsOf(robot_, {placed});
    const bool is_number = isNumber(*best), is_new_number = is_number && !contains(numbers_, placed);
    if (is_new_number) {
      numbers_.push_back(placed);
      renewRows(out, limbs);
    } else if (!is_number) {
      const bool is_all = is_of_all(*best);  // says nothing against effects of single joints
      has_added = add(out, foundOf(*best, entries));
      if (is_all) ++refused_of_all;
      if (!is_all)
        for (const std::size_t limb : limbs) ++refused_in[limb];
    }
    if (has_added || is_new_number) changed.insert(changed.end(), limbs.begin(), limbs.end());
    // What is left by a number that has been moved already is of that number: it has no other name.
    const bool is_done = has_added || is_number;
    dropLimbs(
        [&](std::size_t limb) { return is_done ? isIn(limb, limbs) : refused_in[limb] >= thresholds::kRefusedOfLimb; });
    if (refused_of_all >= thresholds::kRefusedOfLimb) std::erase_if(entries, is_of_all);
  }
  // Where logs refuse the effects of all joints, those of single ones come next.
  if (are_of_all && changed.empty() && refused_of_all > 0) return true;
  for (const std::size_t limb : open) {
    const auto is_left = [&](const auto& entry) {
      return isAcceptable(entry) && isInOneOf(robot_, entry.placed(), {limb});
    };
    if (!isIn(limb, changed) && std::ranges::none_of(entries, is_left)) closed_.push_back(limb);
  }
  return !changed.empty();
}

FoundMechanics ForwardSelection::foundOf(const MechanicsEntry& best, const std::vector<MechanicsEntry>& entries) const {
  const std::vector<std::size_t> limbs = limbsOf(robot_, {best.placed()});
  // Neither what logs refused nor what only another limb shows is a rival.
  std::vector<MechanicsEntry> rivals{best};
  for (const MechanicsEntry& entry : entries)
    if (!entry.placed().sameName(best.placed()) && !contains(refused_, entry.placed()) &&
        isInOneOf(robot_, entry.placed(), limbs))
      rivals.push_back(entry);
  return {.placed = best.placed(),
          .sigmas = {},
          .rivals = rivalsOf(rivals),
          .gain = best.gain,
          .excess_before = sumOver(limbs, excess_)};
}

void ForwardSelection::addAll(MechanicsSelection& out) {
  while (out.found.size() < thresholds::kMostMechanics && step(out)) {
  }
}

void ForwardSelection::run(MechanicsSelection& out) {
  renewRows(out, limbsOf(robot_, effectsOf(out.found)));
  addAll(out);
  const std::vector<std::size_t> dropped = dropSuperfluous(robot_, out.found);
  if (dropped.empty()) return;
  renewRows(out, dropped);
  addAll(out);
}

}  // namespace

MechanicsSelection identifyMechanics(ClampedRobot& robot, const BodyTable& table) {
  MechanicsSelection out;
  out.found = identifyControllers(robot.given(), robot.baseline(), table.open_from);
  if (!robot.isTestable()) return out;
  if (!out.found.empty()) robot.renew(limbsOf(robot, effectsOf(out.found)), with(robot, effectsOf(out.found)));
  ForwardSelection search{robot, table};
  search.run(out);
  const std::size_t count = out.found.size();
  dropUnexplained(robot, table.open_from, out);
  if (out.found.size() < count) search.renewRows(out, {});
  setOwn(robot.baseline(), out.found);
  for (const std::size_t limb : limbsOf(robot, effectsOf(out.found)))
    for (const Link& link : robot.limbs()[limb]) out.touched.push_back(link.joint);
  return out;
}

}  // namespace darwinop::gap
