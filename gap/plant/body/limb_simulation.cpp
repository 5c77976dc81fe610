#include "gap/plant/body/limb_simulation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "gap/plant/body/limb_dynamics.hpp"

namespace darwinop::gap {
namespace {

constexpr double kStopTime = 0.005;  // s in which a mechanical stop pushes a joint back
constexpr double kFarthest = 100;    // rad

}  // namespace

LimbSimulation::LimbSimulation(const BodyCase& given, std::size_t log, const Limb& limb,
                               const BodyHypothesis& hypothesis, const Disturbance* noise)
    : links_{linksOf(limb, hypothesis)},
      n_{static_cast<Eigen::Index>(limb.size())},
      period_{hypothesis.servos.servo.firmware_period_s} {
  const Axes& up = given.logs[log].up.value();
  gravity_ = -kGravity * Eigen::Vector3d{up[0], up[1], up[2]};
  position_ = velocity_ = offset_ = armature_ = outside_ = noise_nm_ = LimbVector::Zero(n_);
  impulses_ = {LimbVector::Zero(n_), LimbVector::Zero(n_)};
  if (noise != nullptr) {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const twin::ServoParameters& servo = hypothesis.servos.servo;
      noise_.emplace_back(*noise, noise->seed * kJoints + static_cast<std::size_t>(links_[i].joint), period_,
                          2 * kPi / servo.ticks_per_rev);
    }
  }
  for (Eigen::Index i = 0; i < n_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    servos_.push_back(servoOf(hypothesis, links_[k].joint, noise == nullptr));
    const twin::LoadChange change = servos_[k].load();
    Link& link = links_[k];
    offset_[i] = change.angle_offset_rad;
    armature_[i] = servos_[k].parameters().armature_kgm2 + change.armature_kgm2;
    link.mass_kg *= change.mass_scale, link.inertia_kgm2 *= change.mass_scale;
    if (const double distance = link.com_m.norm(); distance > 0)
      link.com_m *= std::max(0.0, distance + change.com_shift_m) / distance;
    const Trajectory& rows = given.joint(log, static_cast<std::size_t>(link.joint));
    // Friction may hold a joint away from its goal: a recording begins where the joint was measured.
    const double measured = rows.position_rad.front();
    const bool is_recorded = rows.isReadAfterWrite() && !std::isnan(measured);
    const double reading = is_recorded ? measured : rows.goal_rad.front();
    position_[i] = reading - offset_[i];
    servos_[k].reset(reading, given.logs[log].session_start_s - kHeldBefore);
    gears_.emplace_back();
    soft_.push_back(servos_[k].softGear());
    if (soft_[k]) steps_ = static_cast<int>(std::ceil(period_ / kElasticStep - 1e-9));
  }
  drives_.resize(links_.size());
  if (std::ranges::find(soft_, true) != soft_.end()) settleGears(position_ + offset_);
}

/// At rest, play and spring of a gear are as far apart as it takes to carry the limb. What a spring gives changes the
/// pose by less and less.
void LimbSimulation::settleGears(const LimbVector& readings) {
  constexpr int kRounds = 10;
  for (int round = 0; round < kRounds; ++round) {
    const LimbVector needed = LimbDynamics{links_, position_, velocity_, gravity_}.bias;
    for (Eigen::Index i = 0; i < n_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (soft_[k])
        position_[i] = gears_[k].rest(servos_[k].signals(), readings[i], needed[i], armature_[i]) - offset_[i];
    }
  }
}

void LimbSimulation::cycle() {
  for (Eigen::Index i = 0; i < n_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double arm = position_[i] + offset_[i];
    double seen = soft_[k] ? gears_[k].encoderRad(servos_[k].signals(), arm) : arm;
    ServoDrive drive = drives_[k];
    if (!noise_.empty()) {
      seen += noise_[k].encoder_rad * noise_[k].encoder.normal();
      drive.supply_v += noise_[k].supply_v.next();
      noise_nm_[i] = noise_[k].torque_nm.next();
    }
    servos_[k].firmware(drive, seen, velocity_[i]);
  }
  for (int step = 0; step < steps_; ++step) mechanicalStep(period_ / steps_);
}

void LimbSimulation::mechanicalStep(double dt) {
  const LimbDynamics motion{links_, position_, velocity_, gravity_};
  LimbMatrix mass = motion.mass;
  LimbVector torque = noise_nm_ - motion.bias, own = LimbVector::Zero(n_), damping = own, friction = own;
  LimbVector low = own, high = own;
  for (Eigen::Index i = 0; i < n_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double arm = position_[i] + offset_[i];
    if (soft_[k]) {
      // The arm side moves by the torque of the gears; within the step it is predicted by its inertia alone.
      own[i] = gears_[k].step(servos_[k], {arm, velocity_[i], motion.mass(i, i), outside_[i]}, dt);
    } else {
      const twin::Actuation act = servos_[k].actuate(arm, velocity_[i], outside_[i]);
      mass(i, i) += armature_[i];
      own[i] = act.torque_nm, damping[i] = act.damping_nms_rad, friction[i] = act.friction_nm * dt;
    }
    low[i] = (links_[k].low_rad - position_[i]) / std::max(dt, kStopTime);
    high[i] = (links_[k].high_rad - position_[i]) / std::max(dt, kStopTime);
    if (low[i] < 0) low[i] = (links_[k].low_rad - position_[i]) / dt;
    if (high[i] > 0) high[i] = (links_[k].high_rad - position_[i]) / dt;
  }
  // Trapezoidal rule for damping: the back EMF takes 8 % of the speed in a period.
  LimbMatrix left = mass;
  left.diagonal() += damping * (dt / 2);
  const LimbVector right = mass * velocity_ - (damping * (dt / 2)).cwiseProduct(velocity_) + (torque + own) * dt;
  const LimbMatrix inverse = left.llt().solve(LimbMatrix::Identity(n_, n_));
  const LimbVector before = velocity_;
  velocity_ = withFriction(inverse * right, inverse, friction, low, high, impulses_);
  position_ += (before + velocity_) * (dt / 2);
  // Outside of a servo: all that accelerates its own inertia but its own torques.
  for (Eigen::Index i = 0; i < n_; ++i) {
    const double servo = own[i] - damping[i] * (before[i] + velocity_[i]) / 2 + impulses_.friction[i] / dt;
    outside_[i] = mass(i, i) * (velocity_[i] - before[i]) / dt - servo;
  }
}

bool LimbSimulation::isFinite() const {
  return position_.cwiseAbs().maxCoeff() < kFarthest;
}

}  // namespace darwinop::gap
