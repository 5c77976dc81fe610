#include "gap/identify/body/mechanics_screen.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "gap/identify/body/ripple_screen.hpp"
#include "gap/parallel/parallel.hpp"

namespace darwinop::gap {
namespace {

/// What a simulation with these values in these joints of a limb changes in its residuals.
struct Response {
  std::size_t limb = 0;
  std::vector<Joint> joints;
  const MechanicalEffect* effect = nullptr;
  std::vector<double> values;
  Eigen::VectorXd change;
};

/// Greatest drop of the robust cost along `change`: of 0 to 1.5 times it.
struct Drop {
  double gain = 0, factor = 1;
};
Drop dropAlong(const Eigen::VectorXd& base, const Eigen::VectorXd& change, double base_cost) {
  Drop best;
  const double square = change.squaredNorm();
  if (!(square > 0)) return best;
  const double least_squares = base.dot(change) / square;
  for (const double factor : {std::clamp(least_squares, 0.05, 1.5), 1.0, 0.5}) {
    const double gain = base_cost - robustCost(base - factor * change);
    if (gain > best.gain) best = {gain, factor};
  }
  return best;
}

std::vector<double> between(const MechanicalEffect& effect, const std::vector<double>& now,
                            const std::vector<double>& start, double factor) {
  std::vector<double> out = start;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (!effect.numbers[i].is_secondary) {
      const auto& number = effect.numbers[i];
      const bool down_from_high = number.is_logarithmic && number.neutral != 0;
      // A limit that starts at infinity is not scaled.
      if (!down_from_high) out[i] = std::clamp(now[i] + factor * (start[i] - now[i]), number.low, number.high);
    }
  return out;
}

/// Mass, or shift of the centre of mass, of all starts of a link together: they are linear.
MechanicsCandidate linkCandidate(const MechanicalEffect& effect, Joint joint, const std::vector<const Response*>& parts,
                                 const Eigen::VectorXd& base, double base_cost) {
  Eigen::MatrixXd columns(base.size(), static_cast<Eigen::Index>(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = parts[i]->change;
  Eigen::MatrixXd normal = columns.transpose() * columns;
  normal.diagonal() *= 1 + 1e-6;
  normal.diagonal().array() += 1e-3;
  const Eigen::VectorXd factors = normal.ldlt().solve(columns.transpose() * base);
  MechanicsCandidate out{.placed = {&effect, {joint}, std::vector<double>(effect.numbers.size(), 0.0)}};
  std::vector<double>& values = out.placed.values;
  const bool is_mass = effect.numbers.front().unit == "kg";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::vector<double>& of = parts[i]->values;
    const double factor = factors[static_cast<Eigen::Index>(i)];
    if (is_mass) values[0] += factor * of[0];
    for (std::size_t k = is_mass ? 1 : 0; k < of.size(); ++k) values[k] += factor * of[k] * (is_mass ? of[0] : 1);
  }
  if (is_mass && values[0] != 0)
    for (std::size_t k = 1; k < values.size(); ++k) values[k] /= values[0];
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = std::clamp(values[k], effect.numbers[k].low * 0.99, effect.numbers[k].high * 0.99);
  out.predicted_gain = base_cost - robustCost(base - columns * factors);
  return out;
}

/// One simulation each. `joints`: sets of joints of one limb.
std::vector<Response> responsesOf(const ClampedRobot& robot, const BodyHypothesis& now,
                                  const std::vector<std::vector<Joint>>& sets, const std::vector<Eigen::VectorXd>& base,
                                  bool with_links) {
  std::vector<Response> out;
  for (const std::vector<Joint>& joints : sets)
    for (const MechanicalEffect& effect : mechanicalEffects())
      if (!isRipple(effect) && (with_links || !effect.is_of_link))
        for (const std::vector<double>& start : startsOf(effect, effect.values_in(now, joints.front())))
          out.push_back({robot.limbOf(joints.front()), joints, &effect, start, {}});
  forEach(out.size(), [&](std::size_t i) {
    Response& one = out[i];
    BodyHypothesis moved = now;
    for (const Joint joint : one.joints) one.effect->apply(moved, joint, one.values);
    one.change = base[one.limb] - robot.residuals(one.limb).of(moved);
  });
  return out;
}

/// Responses of one effect, by the first joint of their set, in the order of its starts.
using ByJoint = std::map<Joint, std::vector<const Response*>>;

/// The same start in several sets of joints, in sum: they act on each other little.
MechanicsCandidate groupOf(const MechanicalEffect& effect, const std::vector<std::vector<const Response*>>& sets,
                           const BodyHypothesis& now, const std::vector<Eigen::VectorXd>& base,
                           const std::vector<double>& cost) {
  MechanicsCandidate best{.placed = {&effect, {}, {}}};
  for (const auto& set : sets)
    best.placed.joints.insert(best.placed.joints.end(), set.front()->joints.begin(), set.front()->joints.end());
  std::ranges::sort(best.placed.joints);
  const std::size_t starts = sets.front().size();
  for (std::size_t start = 0; start < starts; ++start) {
    std::map<std::size_t, Eigen::VectorXd> change;
    for (const auto& set : sets) {
      if (set.size() != starts) return best;
      const auto [place, is_new] = change.try_emplace(set[start]->limb, set[start]->change);
      if (!is_new) place->second += set[start]->change;
    }
    Eigen::Index size = 0;
    for (const auto& [limb, part] : change) size += part.size();
    Eigen::VectorXd from(size), along(size);
    Eigen::Index begin = 0;
    double before = 0;
    for (const auto& [limb, part] : change) {
      from.segment(begin, part.size()) = base[limb];
      along.segment(begin, part.size()) = part;
      begin += part.size(), before += cost[limb];
    }
    const Drop drop = dropAlong(from, along, before);
    if (!(drop.gain > best.predicted_gain)) continue;
    best.predicted_gain = drop.gain;
    best.placed.values =
        between(effect, effect.values_in(now, best.placed.joints.front()), sets.front()[start]->values, drop.factor);
  }
  return best;
}

std::vector<std::size_t> screened(const ClampedRobot& robot, const std::vector<std::size_t>& limbs,
                                  ScreenedPlaces places) {
  if (places == ScreenedPlaces::kAny) return limbs;
  std::vector<std::size_t> all(robot.limbs().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

std::vector<MechanicsCandidate> screenMechanics(const ClampedRobot& robot, const std::vector<std::size_t>& limbs,
                                                const std::vector<PlacedMechanics>& found, ScreenedPlaces places) {
  const BodyHypothesis now = with(robot, found);
  std::vector<Eigen::VectorXd> base(robot.limbs().size());
  std::vector<double> cost(robot.limbs().size());
  std::vector<std::vector<Joint>> sets;
  for (const std::size_t limb : screened(robot, limbs, places)) {
    base[limb] = robot.residuals(limb).of(now);
    cost[limb] = robustCost(base[limb]);
    if (places == ScreenedPlaces::kAllJoints) sets.emplace_back();
    for (const Link& link : robot.limbs()[limb]) {
      if (places == ScreenedPlaces::kAllJoints)
        sets.back().push_back(link.joint);
      else
        sets.push_back({link.joint});
    }
  }
  const std::vector<Response> responses = responsesOf(robot, now, sets, base, places == ScreenedPlaces::kAny);
  std::vector<MechanicsCandidate> out;
  const auto add = [&](MechanicsCandidate candidate) {
    const auto is_same = [&](const PlacedMechanics& other) { return other.sameName(candidate.placed); };
    if (candidate.predicted_gain > 0 && std::ranges::none_of(found, is_same)) out.push_back(std::move(candidate));
  };
  for (const MechanicalEffect& effect : mechanicalEffects()) {
    ByJoint by_joint;
    for (const Response& one : responses)
      if (one.effect == &effect) by_joint[one.joints.front()].push_back(&one);
    std::vector<std::vector<const Response*>> all;
    for (const auto& [joint, parts] : by_joint) {
      all.push_back(parts);
      if (places == ScreenedPlaces::kAllJoints) continue;
      const std::size_t limb = robot.limbOf(joint);
      if (effect.is_of_link) {
        add(linkCandidate(effect, joint, parts, base[limb], cost[limb]));
        continue;
      }
      add(groupOf(effect, {parts}, now, base, cost));
      const std::optional<Joint> left = leftOf(joint);
      if (left && by_joint.contains(*left)) add(groupOf(effect, {parts, by_joint[*left]}, now, base, cost));
    }
    if (places == ScreenedPlaces::kAllJoints && !all.empty()) add(groupOf(effect, all, now, base, cost));
  }
  for (MechanicsCandidate& one : rippleCandidates(robot, now, sets, places, base)) add(std::move(one));
  std::ranges::stable_sort(out, std::greater{}, &MechanicsCandidate::predicted_gain);
  return out;
}

}  // namespace darwinop::gap
