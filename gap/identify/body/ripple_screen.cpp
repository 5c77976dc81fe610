#include "gap/identify/body/ripple_screen.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "gap/parallel/parallel.hpp"
#include "gap/plant/body/limb_dynamics.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

/// A joint whose servo holds a goal: what a small torque moves it by. Dry friction is left out: a joint that moves has
/// all of it anyway.
struct PositionLoop {
  double inertia_kgm2, damping_nms_rad, stiffness_per_p;  // N m/rad per unit of the P register

  /// rad, of each row. A limp joint and its way back are another matter.
  [[nodiscard]] Eigen::VectorXd deflection(const Trajectory& rows, const Eigen::VectorXd& torque_nm) const {
    constexpr int kSteps = 4;  // of a row of 16 ms
    Eigen::VectorXd out = Eigen::VectorXd::Zero(torque_nm.size());
    double angle = 0, speed = 0;
    for (std::size_t row = 1; row < rows.rows(); ++row) {
      if (rows.torque_on[row - 1] == 0) {
        angle = speed = 0;
        continue;
      }
      const auto at = static_cast<Eigen::Index>(row);
      const double dt = (rows.time_s[row] - rows.time_s[row - 1]) / kSteps;
      const double stiffness = stiffness_per_p * rows.pRegisterAt(row - 1);
      for (int step = 0; step < kSteps; ++step) {
        const double torque = torque_nm[at - 1] + (step + 0.5) / kSteps * (torque_nm[at] - torque_nm[at - 1]);
        speed += dt / inertia_kgm2 * (torque - stiffness * angle);
        speed /= 1 + dt / inertia_kgm2 * (damping_nms_rad + dt * stiffness);
        angle += dt * speed;
      }
      out[at] = angle;
    }
    return out;
  }
};

PositionLoop loopOf(const ClampedRobot& robot, const BodyHypothesis& now, Joint joint, double supply_v) {
  const twin::ServoParameters& servo = now.servos.servo;
  const Limb& limb = robot.limbs()[robot.limbOf(joint)];
  const LimbVector rest = LimbVector::Zero(static_cast<Eigen::Index>(limb.size()));
  const LimbMatrix mass = LimbDynamics{limb, rest, rest, Eigen::Vector3d::Zero()}.mass;
  const auto at = std::ranges::find(limb, joint, &Link::joint) - limb.begin();
  const double per_volt = servo.kt_nm_a / servo.resistance_ohm;
  return {mass(at, at) + servo.armature_kgm2, per_volt * servo.back_emf_vs_rad,
          per_volt * supply_v * servo.duty_per_kp_per_rad};
}

/// The ripple as the angle that was measured has it; 0 where it was not.
Eigen::VectorXd rippleOn(const Trajectory& rows, double count, double phase) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(rows.rows()));
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    const double angle = rows.position_rad[row];
    out[static_cast<Eigen::Index>(row)] = std::isnan(angle) ? 0 : std::sin(count * angle + phase);
  }
  return out;
}

/// All joints, or each one and each pair.
std::vector<std::vector<Joint>> placesOf(const std::vector<std::vector<Joint>>& sets, ScreenedPlaces places) {
  std::vector<Joint> joints;
  for (const auto& set : sets) joints.insert(joints.end(), set.begin(), set.end());
  std::ranges::sort(joints);
  if (places == ScreenedPlaces::kAllJoints) return {joints};
  std::vector<std::vector<Joint>> out = sets;
  for (const Joint joint : joints)
    if (const std::optional<Joint> left = leftOf(joint); left && std::ranges::binary_search(joints, *left))
      out.push_back({joint, *left});
  return out;
}

}  // namespace

bool isRipple(const MechanicalEffect& effect) {
  return !effect.is_of_link && twin::indexOf(*twin::findEffect(effect.id), twin::ParameterRole::kRippleTorque) == 0;
}

RippleScan scanRipples(const ClampedRobot& robot, const BodyHypothesis& now, Joint joint, const Eigen::VectorXd& left) {
  const LimbResiduals& residuals = robot.residuals(robot.limbOf(joint));
  RippleScan out(thresholds::kMaxRipplesPerTurn + 1);
  for (const LimbSamples& block : residuals.blocks()) {
    if (block.is_load || residuals.limb()[static_cast<std::size_t>(block.joint)].joint != joint) continue;
    const Trajectory& rows = robot.given().joint(block.log, static_cast<std::size_t>(joint));
    const PositionLoop loop = loopOf(robot, now, joint, robot.given().logs[block.log].battery_v);
    const Eigen::VectorXd there = left.segment(block.begin, block.rows);
    // A sample that is missing is exactly 0.
    const Eigen::VectorXd weight =
        (there.array() != 0).select(residuals.sigma().segment(block.begin, block.rows).cwiseInverse(), 0);
    for (int count = thresholds::kFewestRipples; count <= thresholds::kMaxRipplesPerTurn; ++count) {
      Eigen::MatrixX2d columns(block.rows, 2);
      for (const int k : {0, 1})
        columns.col(k) = loop.deflection(rows, rippleOn(rows, count, k * kPi / 2)).cwiseProduct(weight);
      RippleSums& sums = out[static_cast<std::size_t>(count)];
      sums.gram += columns.transpose() * columns;
      sums.along += columns.transpose() * there;
    }
  }
  return out;
}

std::vector<std::vector<double>> ripplesIn(const std::vector<const RippleScan*>& joints) {
  std::vector<double> explained(thresholds::kMaxRipplesPerTurn + 1, 0.0);
  std::vector<Eigen::Vector2d> amount(explained.size(), Eigen::Vector2d::Zero());
  for (std::size_t count = thresholds::kFewestRipples; count < explained.size(); ++count) {
    RippleSums sum;
    for (const RippleScan* const joint : joints) sum.gram += (*joint)[count].gram, sum.along += (*joint)[count].along;
    if (!(sum.gram.determinant() > 0)) continue;
    amount[count] = sum.gram.ldlt().solve(sum.along);
    explained[count] = amount[count].dot(sum.along);
  }
  std::vector<std::vector<double>> out;
  while (out.size() < thresholds::kScreenedRipples) {
    const auto best = static_cast<std::size_t>(std::ranges::max_element(explained) - explained.begin());
    if (!(explained[best] > 0)) break;
    out.push_back({amount[best].norm(), static_cast<double>(best), std::atan2(amount[best][1], amount[best][0])});
    for (std::size_t count = best - 1; count <= best + 1 && count < explained.size(); ++count) explained[count] = 0;
  }
  return out;
}

std::vector<MechanicsCandidate> rippleCandidates(const ClampedRobot& robot, const BodyHypothesis& now,
                                                 const std::vector<std::vector<Joint>>& sets, ScreenedPlaces places,
                                                 const std::vector<Eigen::VectorXd>& left) {
  const MechanicalEffect& effect = *std::ranges::find_if(mechanicalEffects(), isRipple);
  std::vector<RippleScan> scans(kJoints);
  forEach(kJoints, [&](std::size_t i) {
    const auto joint = static_cast<Joint>(i);
    if (left[robot.limbOf(joint)].size() > 0) scans[i] = scanRipples(robot, now, joint, left[robot.limbOf(joint)]);
  });
  std::vector<MechanicsCandidate> out;
  for (const std::vector<Joint>& joints : placesOf(sets, places)) {
    std::vector<const RippleScan*> of;
    for (const Joint joint : joints) of.push_back(&scans[static_cast<std::size_t>(joint)]);
    for (std::vector<double>& values : ripplesIn(of)) {
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::clamp(values[i], effect.numbers[i].low, effect.numbers[i].high);
      out.push_back({.placed = {&effect, joints, std::move(values)}});
    }
  }
  forEach(out.size(), [&](std::size_t i) {
    BodyHypothesis moved = now;
    out[i].placed.applyTo(moved);
    for (const std::size_t limb : limbsOf(robot, {out[i].placed}))
      out[i].predicted_gain += robustCost(left[limb]) - robustCost(robot.residuals(limb).of(moved));
  });
  return out;
}

}  // namespace darwinop::gap
