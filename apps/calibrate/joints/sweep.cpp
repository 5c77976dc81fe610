#include "apps/calibrate/joints/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>

#include "apps/calibrate/messages.hpp"
#include "core/servo_limits.hpp"

namespace darwinop::calibrate {
namespace {

constexpr double kTakeOverS = 5;
constexpr double kMoveSpeed = 0.7;    // rad/s, mean
constexpr std::size_t kBins = 8;      // over the whole amplitude
constexpr double kFilledShare = 0.8;  // a bin that a turn cuts is left out
constexpr double kGoldenRatio = std::numbers::phi;
// Duty per unit of gain and rad: twice the manual's, as core/servo_limits.hpp says. The fit corrects it.
constexpr double kDutyPerUnit = 2 / kFullDriveError;
// After a turn a joint sticks, then gains speed with a time constant of back EMF over gain: 0.43 N m s/rad over 3.2 N
// m/rad with P gain 1. From this share of the commanded speed on, five of them leave 0.1 % of back EMF and
// acceleration.
constexpr double kMovingShare = 0.85, kTimeConstantS = 0.14, kTimeConstants = 5;
constexpr std::size_t kSpeedCycles = 8;  // of the speed: one tick in 0.13 s is 0.012 rad/s

/// Duty that the control law derives from goal and position. The load register shows the same, but in so coarse steps
/// that with some gains a tick of error is nearly a whole number of them, and their rounding does not average out.
double dutyOf(const JointSensors& joint, double p_gain) {
  const double error = std::nearbyint(joint.commanded.value / kRadPerTick) * kRadPerTick - joint.position.value;
  return kDutyPerUnit * p_gain * error;
}

/// Samples of one direction within one bin.
struct Half {
  double count = 0, load = 0, squares = 0;
  JointValues angles{};

  void take(const Sensors& seen, std::size_t joint, double p_gain) {
    const double now = dutyOf(seen.joint[joint], p_gain);
    ++count, load += now, squares += now * now;
    for (std::size_t i = 0; i < kJoints; ++i) {
      const Rad at = seen.joint[i].position;
      angles[i] += at.known() ? at.value : 0;  // absent, and so in another limb
    }
  }
  [[nodiscard]] double mean() const { return load / count; }
  [[nodiscard]] double varianceOfMean(double p_gain) const {
    const double step = kDutyPerUnit * p_gain * kRadPerTick;
    return std::max(squares / count - mean() * mean(), step * step / 12) / count;
  }
};

/// Bins of one swept joint by its angle, forth and back.
class Bins {
 public:
  Bins(std::size_t joint, const SweepOfJoint& sweep) : joint_{joint}, sweep_{sweep} {}

  /// `way`: of the goal since the sweep began, rad, there and back.
  void take(const Sensors& seen, double way, double period_s) {
    const bool rising = way <= 2 * sweep_.amplitude_rad;
    if (way > 4 * sweep_.amplitude_rad) return;  // waits for the others
    const JointSensors& joint = seen.joint[joint_];
    if (rising != rising_ || !joint.motion.fresh() || !joint.driven) {
      rising_ = rising, steady_s_ = 0;
      return recent_.clear();
    }
    recent_.push_back(joint.position.value);
    if (recent_.size() <= kSpeedCycles) return;
    recent_.pop_front();
    const double speed = (recent_.back() - recent_.front()) / (static_cast<double>(kSpeedCycles - 1) * period_s);
    const bool is_moving = (rising ? speed : -speed) >= kMovingShare * kSweepSpeed;
    if (is_moving || steady_s_ > 0) steady_s_ += period_s;
    if (steady_s_ < kTimeConstants * kTimeConstantS / sweep_.p_gain) return;
    const double used = sweep_.amplitude_rad;
    const double share = (joint.position.value - sweep_.base_rad + used) / (2 * used);
    if (!(share >= 0 && share < 1)) return;
    bins_[static_cast<std::size_t>(share * kBins)][rising ? 1 : 0].take(seen, joint_, sweep_.p_gain);
  }

  void appendPoints(const std::array<double, 3>& up, double period_s, std::vector<GravityPoint>& out) const {
    const double full = 2 * sweep_.amplitude_rad / kBins / (kSweepSpeed * period_s);
    for (const auto& [back, forth] : bins_) {
      if (std::min(back.count, forth.count) < kFilledShare * full) continue;
      GravityPoint point{
          .joint = static_cast<Joint>(joint_),
          .angles_rad = {},
          .load = (back.mean() + forth.mean()) / 2,
          .sigma = std::sqrt(back.varianceOfMean(sweep_.p_gain) + forth.varianceOfMean(sweep_.p_gain)) / 2,
          .up = up};
      for (std::size_t i = 0; i < kJoints; ++i)
        point.angles_rad[i] = (back.angles[i] / back.count + forth.angles[i] / forth.count) / 2;
      out.push_back(point);
    }
  }

 private:
  std::size_t joint_;
  SweepOfJoint sweep_;
  bool rising_ = false;
  double steady_s_ = 0;        // since the joint reached its speed
  std::deque<double> recent_;  // angles of successive cycles
  std::array<std::array<Half, 2>, kBins> bins_{};
};

}  // namespace

Sweeper::Sweeper(runtime::DriverSession& session, const std::bitset<kJoints>& left_out, const std::atomic<bool>& stop)
    : session_{session}, driven_{~left_out}, stop_{stop} {
  commands_.start_where_it_is = true;
  session_.start();
  Sensors seen = session_.sensors();
  const double cycles = kTakeOverS / (static_cast<double>(session_.link().period().count()) * 1e-9);
  const auto all_driven = [&] {
    bool all = session_.drives(seen);
    forEachJoint(driven_, [&](std::size_t i) { all = all && seen.joint[i].driven; });
    return all;
  };
  for (int cycle = 0; cycle < cycles && !all_driven() && !stop_; ++cycle) {
    forEachJoint(driven_, [&](std::size_t i) {
      const Rad at = seen.joint[i].position;
      if (!at.known()) return;
      goal_[i] = at.value;
      commands_.joint[i].setGoal(at);
      commands_.joint[i].setPGain(sweepOf(static_cast<Joint>(i)).p_gain);
    });
    seen = step();
  }
  if (!all_driven() && !stop_) throw std::runtime_error(messages::kNotDriven);
}

Sensors Sweeper::step() {
  session_.publish(commands_);
  if (!session_.waitForCycle(session_.sensors().cycle + 1, stop_) && !stop_)
    throw std::runtime_error(session_.link().whyEnded());
  const Sensors seen = session_.sensors();
  if (const std::string why = session_.faultEnd(seen); !why.empty()) throw std::runtime_error(why);
  return seen;
}

void Sweeper::release() {
  constexpr int kCycles = 60;  // 1 s: limbs swing down and come to rest
  forEachJoint(driven_, [&](std::size_t i) { commands_.joint[i] = {}, commands_.joint[i].setTorque(false); });
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    session_.publish(commands_);
    if (!session_.waitForCycle(session_.sensors().cycle + 1)) return;
  }
  session_.end(commands_);
}

void Sweeper::moveTo(const JointValues& pose) {
  const JointValues from = goal_;
  double longest = 0;
  forEachJoint(driven_, [&](std::size_t i) { longest = std::max(longest, std::abs(pose[i] - from[i])); });
  const double period = static_cast<double>(session_.link().period().count()) * 1e-9;
  const auto cycles = static_cast<int>(std::ceil((longest / kMoveSpeed + 0.3) / period));
  for (int cycle = 1; cycle <= cycles && !stop_; ++cycle) {
    const double share = (1 - std::cos(kPi * cycle / cycles)) / 2;
    forEachJoint(driven_, [&](std::size_t i) {
      goal_[i] = from[i] + share * (pose[i] - from[i]);
      commands_.joint[i].setGoal(Rad{goal_[i]});
    });
    step();
  }
}

std::vector<GravityPoint> Sweeper::sweep(const std::bitset<kJoints>& joints, const std::array<double, 3>& up) {
  const std::bitset<kJoints> swept = joints & driven_;
  const double period = static_cast<double>(session_.link().period().count()) * 1e-9;
  // Repeats begin at other fractions of a tick, so that their rounding errors differ.
  const double shift = kRadPerTick * std::fmod(kGoldenRatio * ++sweeps_, 1);
  std::vector<Bins> bins;
  JointValues low = basePose();
  double longest = 0;
  forEachJoint(swept, [&](std::size_t i) {
    const SweepOfJoint of = sweepOf(static_cast<Joint>(i));
    bins.emplace_back(i, of);
    low[i] += shift - of.amplitude_rad;
    longest = std::max(longest, of.amplitude_rad);
  });
  moveTo(low);
  const auto cycles = static_cast<int>(4 * longest / (kSweepSpeed * period));
  for (int cycle = 1; cycle <= cycles && !stop_; ++cycle) {
    const double way = cycle * period * kSweepSpeed;
    forEachJoint(swept, [&](std::size_t i) {
      const double range = 2 * sweepOf(static_cast<Joint>(i)).amplitude_rad;
      goal_[i] = low[i] + std::max(0.0, way <= range ? way : 2 * range - way);
      commands_.joint[i].setGoal(Rad{goal_[i]});
    });
    const Sensors seen = step();
    for (Bins& one : bins) one.take(seen, way, period);
  }
  std::vector<GravityPoint> out;
  for (const Bins& one : bins) one.appendPoints(up, period, out);
  moveTo(basePose());
  return out;
}

}  // namespace darwinop::calibrate
