#include "gap/identify/body/controller_selection.hpp"

#include <algorithm>
#include <cmath>

#include "gap/identify/body/controller_residuals.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

bool isOfController(const MechanicalEffect& effect) {
  if (effect.is_of_link) return false;
  const Block block = blockOf(twin::findEffect(effect.id)->part);
  return block == Block::kCommand || block == Block::kController;
}

class Selection {
 public:
  Selection(const BodyCase& given, const BodyHypothesis& baseline, double open_from)
      : baseline_{baseline}, open_from_{open_from}, fitted_{given, false}, held_out_{given, true} {}

  std::vector<FoundMechanics> run();

 private:
  struct Candidate {
    PlacedMechanics start;
    MechanicsFit fit = {};
    double gain = 0, evidence = 0;
  };

  [[nodiscard]] BodyHypothesis with(const std::vector<PlacedMechanics>& effects) const {
    BodyHypothesis out = baseline_;
    for (const PlacedMechanics& effect : effects) effect.applyTo(out);
    return out;
  }
  [[nodiscard]] std::vector<PlacedMechanics> found() const {
    std::vector<PlacedMechanics> out;
    for (const FoundMechanics& one : found_) out.push_back(one.placed);
    return out;
  }
  [[nodiscard]] Eigen::VectorXd residuals(const ControllerResiduals& of, const std::vector<Joint>& joints,
                                          const std::vector<PlacedMechanics>& effects) const {
    const Hypothesis servos = with(effects).servos;
    Eigen::VectorXd out;
    for (const Joint joint : joints) {
      const Eigen::VectorXd part = of.of(joint, servos);
      out.conservativeResize(out.size() + part.size());
      out.tail(part.size()) = part;
    }
    return out;
  }
  [[nodiscard]] double cost(const ControllerResiduals& of, const std::vector<Joint>& joints,
                            const std::vector<PlacedMechanics>& effects) const {
    return robustCost(residuals(of, joints, effects));
  }

  /// A second effect in one joint is left to the simulation: what remains of a large one looks like others.
  [[nodiscard]] std::vector<Joint> openJoints() const;
  [[nodiscard]] std::vector<Candidate> candidates(const std::vector<Joint>& open) const;
  void fit(Candidate& candidate) const;
  /// False: it explains too little, or the logs that are held out contradict it.
  [[nodiscard]] bool holds(const Candidate& candidate) const;

  /// In one of its joints, close behind it, and not refused itself.
  [[nodiscard]] bool isRivalOf(const Candidate& best, const Candidate& other) const {
    const auto is_shared = [&](Joint joint) { return std::ranges::count(other.start.joints, joint) > 0; };
    return best.evidence - other.evidence < thresholds::kRivalEvidence &&
           std::ranges::any_of(best.start.joints, is_shared) && (other.evidence <= best.evidence || holds(other));
  }

  const BodyHypothesis& baseline_;
  const double open_from_;
  const ControllerResiduals fitted_, held_out_;
  std::vector<FoundMechanics> found_;
};

std::vector<Joint> Selection::openJoints() const {
  const Hypothesis servos = with(found()).servos;
  std::vector<Joint> open;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const auto has_one = [&](const FoundMechanics& one) {
      return std::ranges::find(one.placed.joints, joint) != one.placed.joints.end();
    };
    if (std::ranges::none_of(found_, has_one) && fitted_.significance(joint, servos) > open_from_)
      open.push_back(joint);
  }
  return open;
}

std::vector<Selection::Candidate> Selection::candidates(const std::vector<Joint>& open) const {
  std::vector<std::vector<Joint>> places;
  for (const Joint joint : open) {
    places.push_back({joint});
    if (const std::optional<Joint> left = leftOf(joint); left && std::ranges::find(open, *left) != open.end())
      places.push_back({joint, *left});
  }
  if (open.size() > 2) {
    places.emplace_back();
    for (std::size_t joint = 0; joint < kJoints; ++joint) places.back().push_back(static_cast<Joint>(joint));
  }
  const BodyHypothesis now = with(found());
  std::vector<Candidate> out;
  for (const std::vector<Joint>& joints : places)
    for (const MechanicalEffect& effect : mechanicalEffects())
      if (isOfController(effect))
        for (const std::vector<double>& start : startsOf(effect, effect.values_in(now, joints.front())))
          out.push_back({.start = {&effect, joints, start}});
  return out;
}

void Selection::fit(Candidate& candidate) const {
  std::vector<PlacedMechanics> effects = found();
  const std::vector<Joint>& joints = candidate.start.joints;
  const double before = cost(fitted_, joints, effects);
  effects.push_back(candidate.start);
  const auto of = [&](const std::vector<PlacedMechanics>& moved) { return residuals(fitted_, joints, moved); };
  constexpr double kIndependent = 1;  // ControllerResiduals has seen to rows that count as one
  candidate.fit = fitEffects(of, effects, {effects.size() - 1}, false, thresholds::kMechanicsIterations, kIndependent);
  candidate.gain = before - candidate.fit.cost;
  const double samples =
      static_cast<double>(fitted_.of(joints.front(), baseline_.servos).size()) / thresholds::kCorrelatedSamples;
  candidate.evidence = candidate.gain - namePrice(candidate.start) -
                       static_cast<double>(candidate.fit.numbers) *
                           std::log(std::max(2.0, samples * static_cast<double>(joints.size())));
}

bool Selection::holds(const Candidate& candidate) const {
  const std::vector<Joint>& joints = candidate.start.joints;
  const Hypothesis before = with(found()).servos, after = with(candidate.fit.effects).servos;
  double excess = 0, left = 0;
  for (const Joint joint : joints) {
    const double samples = static_cast<double>(fitted_.of(joint, before).size()) / thresholds::kCorrelatedSamples;
    excess += std::max(0.0, robustCost(fitted_.of(joint, before)) - samples);
    left += std::max(0.0, robustCost(fitted_.of(joint, after)) - samples);
  }
  if (left > (1 - thresholds::kExplainedGapShare) * excess) return false;
  return !(cost(held_out_, joints, candidate.fit.effects) >
           thresholds::kHeldOutRise * cost(held_out_, joints, found()));
}

std::vector<FoundMechanics> Selection::run() {
  while (found_.size() < thresholds::kMostMechanics) {
    std::vector<Candidate> all = candidates(openJoints());
    if (all.empty()) break;
    forEach(all.size(), [&](std::size_t i) { fit(all[i]); });
    std::ranges::stable_sort(all, std::greater{}, &Candidate::evidence);
    // Where one explains too little, or held-out logs contradict it, the search goes on in other joints.
    const auto earns = [&](const Candidate& one) {
      return one.evidence >= -2 * std::log(thresholds::kMechanicalChance) && holds(one);
    };
    const auto first = std::ranges::find_if(all, earns);
    if (first == all.end()) break;
    const Candidate& best = *first;
    FoundMechanics one{.placed = best.fit.effects.back(),
                       .sigmas = best.fit.sigmas.back(),
                       .rivals = {},
                       .gain = best.gain,
                       .is_in_controller = true};
    for (const Candidate& rival : all) {
      const PlacedMechanics& other = rival.fit.effects.back();
      const auto is_same = [&](const PlacedMechanics& listed) { return listed.sameName(other); };
      if (!is_same(one.placed) && std::ranges::none_of(one.rivals, is_same) && isRivalOf(best, rival))
        one.rivals.push_back(other);
    }
    found_.push_back(std::move(one));
  }
  return found_;
}

}  // namespace

std::vector<FoundMechanics> identifyControllers(const BodyCase& given, const BodyHypothesis& baseline,
                                                double open_from) {
  return Selection{given, baseline, open_from}.run();
}

}  // namespace darwinop::gap
