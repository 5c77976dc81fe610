#include "gap/plant/body/limb_roll_out.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "gap/plant/body/dry_friction.hpp"
#include "gap/plant/body/limb_dynamics.hpp"
#include "gap/plant/body/limb_parts.hpp"
#include "hal/body.hpp"
#include "twin/servo/servo.hpp"
#include "twin/servo/transmission.hpp"

namespace darwinop::gap {
namespace {

constexpr double kHeldBefore = 1.0;  // s with the goals of row 0 before it, from rest in that pose
constexpr double kStopTime = 0.005;  // s in which a mechanical stop pushes a joint back
constexpr double kFarthest = 100;    // rad
constexpr double kInstant = 1e-6;    // of a firmware period
constexpr double kMeanPhase = 0.5;   // the same

class LimbSimulation {
 public:
  LimbSimulation(const BodyCase& given, std::size_t log, const Limb& limb, const BodyHypothesis& hypothesis,
                 const Disturbance* noise);
  LimbTrace run();

 private:
  void restOnFlanks();
  void writeRow(std::size_t row);
  void readRow(Eigen::Index row, Eigen::Index joint, LimbTrace& into) const;
  void runTo(long cycle);
  [[nodiscard]] long cycleAt(std::size_t row, double after_s, double phase) const;
  void cycle();
  void mechanicalStep(double dt);
  [[nodiscard]] const Trajectory& rowsOf(Eigen::Index joint) const {
    return given_.joint(log_, static_cast<std::size_t>(links_[static_cast<std::size_t>(joint)].joint));
  }

  const BodyCase& given_;
  const BodyHypothesis& hypothesis_;
  std::size_t log_;
  Limb links_;
  Eigen::Index n_;
  double period_;
  Eigen::Vector3d gravity_;
  std::vector<JointNoise> noise_;  // none: the run is exact
  LimbVector noise_nm_;
  std::vector<twin::Servo> servos_;
  std::vector<twin::Transmission> gears_;
  std::vector<ServoDrive> drives_;
  std::vector<bool> soft_;
  int steps_ = 1;  // in a period of the firmware
  // True angles of the arm side, and what the encoder adds to them.
  LimbVector position_, velocity_, offset_, armature_, outside_;
  JointImpulses impulses_;
  long next_ = 0;  // firmware cycle; cycle 0 begins with row 0
  Rng phase_{0};   // of the firmware against the rows, where it is not known
};

LimbSimulation::LimbSimulation(const BodyCase& given, std::size_t log, const Limb& limb,
                               const BodyHypothesis& hypothesis, const Disturbance* noise)
    : given_{given},
      hypothesis_{hypothesis},
      log_{log},
      links_{linksOf(limb, hypothesis)},
      n_{static_cast<Eigen::Index>(limb.size())},
      period_{hypothesis.servos.servo.firmware_period_s} {
  const Axes& up = given.logs[log].up.value();
  gravity_ = -kGravity * Eigen::Vector3d{up[0], up[1], up[2]};
  position_ = velocity_ = offset_ = armature_ = outside_ = noise_nm_ = LimbVector::Zero(n_);
  impulses_ = {LimbVector::Zero(n_), LimbVector::Zero(n_)};
  if (noise != nullptr) {
    phase_ = Rng{splitMix(noise->seed)};
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
    const Trajectory& rows = rowsOf(i);
    // Friction may hold a joint away from its goal: a recording begins where the joint was measured.
    const double measured = rows.position_rad.front();
    const bool is_recorded = rows.isReadAfterWrite() && !std::isnan(measured);
    const double reading = is_recorded ? measured : rows.goal_rad.front();
    position_[i] = reading - offset_[i];
    servos_[k].reset(reading, given.logs[log].session_start_s - kHeldBefore);
    gears_.emplace_back();
    soft_.push_back(servos_[k].softGear());
    if (soft_[k]) {
      gears_[k].reset(reading, 0, armature_[i]);
      steps_ = static_cast<int>(std::ceil(period_ / kElasticStep - 1e-9));
    }
  }
  drives_.resize(links_.size());
  restOnFlanks();
}

/// Where a joint with play was measured at rest, its teeth touch on the side on which they carry the limb.
void LimbSimulation::restOnFlanks() {
  if (!rowsOf(0).isReadAfterWrite()) return;
  const LimbVector needed = LimbDynamics{links_, position_, velocity_, gravity_}.bias;
  for (Eigen::Index i = 0; i < n_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double play = servos_[k].signals().backlash_rad;
    if (soft_[k] && play > 0)
      gears_[k].reset(position_[i] + offset_[i] + std::copysign(play / 2, needed[i]), 0, armature_[i]);
  }
}

void LimbSimulation::writeRow(std::size_t row) {
  for (Eigen::Index i = 0; i < n_; ++i) {
    const Trajectory& rows = rowsOf(i);
    ServoDrive& drive = drives_[static_cast<std::size_t>(i)];
    drive.torque_on = rows.torque_on[row] != 0;
    drive.goal_rad = rows.goal_rad[row];
    drive.speed_limit_rad_s =
        rows.speed_limit_rad_s > 0 ? rows.speed_limit_rad_s : std::numeric_limits<double>::infinity();
    drive.torque_limit = 1;
    if (const double p = rows.pRegisterAt(row); !std::isnan(p)) drive.p_gain = p / kPRegisterPerKp;
    drive.supply_v = supplyAt(given_.logs[log_], row, hypothesis_);
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

void LimbSimulation::readRow(Eigen::Index row, Eigen::Index joint, LimbTrace& into) const {
  const twin::Signals& s = servos_[static_cast<std::size_t>(joint)].signals();
  into.position_rad(row, joint) = s.measured_rad;
  into.duty(row, joint) = s.torque_on ? s.duty : 0;
}

void LimbSimulation::runTo(long cycle) {
  for (; next_ < cycle; ++next_) this->cycle();
}

/// The first cycle that is not over `after_s` behind the begin of a row.
long LimbSimulation::cycleAt(std::size_t row, double after_s, double phase) const {
  return static_cast<long>(std::floor((rowsOf(0).time_s[row] + after_s) / period_ + phase + kInstant));
}

LimbTrace LimbSimulation::run() {
  const std::vector<double>& time = rowsOf(0).time_s;
  const auto rows = static_cast<Eigen::Index>(time.size());
  LimbTrace out{Eigen::MatrixXd::Constant(rows, n_, std::numeric_limits<double>::quiet_NaN()), {}};
  out.duty = out.position_rad;
  const bool is_phase_known = given_.logs[log_].is_phase_known;
  std::vector<long> read_at(links_.size());
  writeRow(0);
  next_ = -std::lround(kHeldBefore / period_);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    if (rowsOf(0).isReadAfterWrite()) {
      // Firmware that runs on its own is as old as its period when it is read, by chance.
      const double phase = is_phase_known ? 0 : noise_.empty() ? kMeanPhase : phase_.uniform();
      runTo(cycleAt(r, rowsOf(0).written_s[r], phase));
      writeRow(r);
      for (Eigen::Index i = 0; i < n_; ++i)
        read_at[static_cast<std::size_t>(i)] = cycleAt(r, rowsOf(i).read_s[r], phase);
      for (const long last = std::ranges::max(read_at);; cycle(), ++next_) {
        for (Eigen::Index i = 0; i < n_; ++i)
          if (read_at[static_cast<std::size_t>(i)] == next_) readRow(row, i, out);
        if (next_ >= last) break;
      }
    } else {
      runTo(static_cast<long>(std::ceil(time[r] / period_ - kInstant)));
      for (Eigen::Index i = 0; i < n_; ++i) readRow(row, i, out);
      writeRow(r);
    }
    if (!(position_.cwiseAbs().maxCoeff() < kFarthest)) break;
  }
  return out;
}

}  // namespace

double supplyAt(const BodyLog& log, std::size_t row, const BodyHypothesis& hypothesis) {
  const bool is_measured = hypothesis.has_board_supply && row < log.board_v.size() && !std::isnan(log.board_v[row]);
  return is_measured ? log.board_v[row] : log.battery_v;
}

LimbTrace rollOut(const BodyCase& given, std::size_t log, const Limb& limb, const BodyHypothesis& hypothesis,
                  const Disturbance* noise) {
  return LimbSimulation{given, log, limb, hypothesis, noise}.run();
}

}  // namespace darwinop::gap
