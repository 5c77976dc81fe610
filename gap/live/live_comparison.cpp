#include "gap/live/live_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/live/thresholds.hpp"

namespace darwinop::gap::live {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool isKnown(Freshness age) {
  return age.age <= kAnswerPatience;
}

/// Without a board its servos show whether the robot is there.
bool answers(const Sensors& seen) {
  if (!seen.board.absent) return isKnown(seen.board.motion);
  return std::ranges::any_of(seen.joint, [](const JointSensors& joint) { return isKnown(joint.motion); });
}

/// Speed limits of the servos change in these moves; the next poll shows it too late.
bool isMovedBySafety(State state) {
  return state == State::kTakingOver || state == State::kStarting || state == State::kKneeling;
}

std::size_t cyclesOf(double seconds, double period_s) {
  return static_cast<std::size_t>(std::lround(seconds / period_s));
}

Axes accelOf(const BoardSensors& board) {
  if (!board.motion.fresh()) return {kNone, kNone, kNone};
  return {board.accelerometer[0].value, board.accelerometer[1].value, board.accelerometer[2].value};
}

}  // namespace

std::string_view name(LiveState state) {
  constexpr std::array<std::string_view, 5> kNames{"no_data", "on_its_side", "settling", "comparing", "failed"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view name(Resync reason) {
  constexpr std::array<std::string_view, kResyncs> kNames{"begin", "gap", "silence", "torque", "turned", "new_runtime"};
  return kNames[static_cast<std::size_t>(reason)];
}

LiveComparison::LiveComparison(twin::Model model, Support support, double period_s)
    : acceleration_{model},
      twin_{std::move(model), support},
      cycles_of_turn_{cyclesOf(kTurning, period_s)},
      position_(kJoints, ResidualWindow{cyclesOf(kWindow, period_s)}),
      load_{position_},
      gyro_(3, ResidualWindow{cyclesOf(kWindow, period_s)}),
      accel_{gyro_} {
  measured_rad_.fill(kNone);
}

void LiveComparison::take(const LiveCycle& cycle) {
  const Sensors& seen = cycle.sensors;
  if (seen.cycle == 0 || seen.cycle == last_cycle_ || status_.state == LiveState::kFailed) return;
  const double time_s = static_cast<double>(seen.time_ns) * 1e-9;
  noteOrder(seen);
  const double dt_s = last_cycle_ == 0 ? 0 : std::max(time_s - last_time_s_, 0.0);
  last_cycle_ = seen.cycle, last_time_s_ = time_s;
  ++status_.cycles;
  if (!answers(seen)) {
    status_.state = LiveState::kNoData;
    robot_up_.forget();
    if (!wanted_) wanted_ = Resync::kSilence;
    return;
  }
  for (std::size_t i = 0; i < kJoints; ++i)
    measured_rad_[i] = isKnown(seen.joint[i].motion) ? seen.joint[i].position.value : kNone;
  status_.are_gains_known = !std::isnan(cycle.p_gain[0]);
  noteTorque(seen);
  robot_up_.add(acceleration_.from(accelOf(seen.board)), dt_s);
  if (wanted_) return place(cycle);
  const BodyState& twin = twin_.step(cycle, measured_rad_);
  if (twin_.error() != nullptr) {
    status_.state = LiveState::kFailed, status_.error = twin_.error();
    return;
  }
  twin_up_.add(acceleration_.from(twin.accel_m_s2), dt_s);
  if (isMovedBySafety(seen.safety.state)) settled_at_s_ = time_s + kSettle;
  noteTurn(dt_s);
  if (wanted_) return place(cycle);
  status_.state = time_s < settled_at_s_ ? LiveState::kSettling : LiveState::kComparing;
  if (status_.state == LiveState::kComparing) compare(seen, twin);
}

void LiveComparison::noteOrder(const Sensors& seen) {
  if (last_cycle_ == 0) return;
  if (seen.cycle < last_cycle_) {
    wanted_ = Resync::kNewRuntime;
    robot_up_.forget();
    return;
  }
  const std::uint64_t missing = seen.cycle - last_cycle_ - 1;
  status_.missing += missing;
  if (missing > kMostMissing && !wanted_) wanted_ = Resync::kGap;
}

void LiveComparison::noteTorque(const Sensors& seen) {
  const std::bitset<kJoints> before = status_.driven;
  for (std::size_t i = 0; i < kJoints; ++i) {
    status_.driven[i] = seen.joint[i].driven;
    status_.silent[i] = std::isnan(measured_rad_[i]);
  }
  if ((status_.driven & ~before).any() && !wanted_) wanted_ = Resync::kTorque;
}

/// What was compared since the turn began, is taken back.
void LiveComparison::noteTurn(double dt_s) {
  const std::optional<Axes> robot = robot_up_.up(), twin = twin_up_.up();
  turned_s_ = robot && twin && angleBetween(*robot, *twin) > kTurned ? turned_s_ + dt_s : 0;
  if (turned_s_ < kTurnedFor) return;
  wanted_ = Resync::kTurned;
  for (std::vector<ResidualWindow>* const windows : {&position_, &load_, &gyro_, &accel_})
    for (ResidualWindow& window : *windows) window.forgetLast(cycles_of_turn_);
}

/// Joints that are silent are put where their goals are. Nothing shows how a robot without a board is turned: upright.
void LiveComparison::place(const LiveCycle& cycle) {
  const std::optional<Axes> up = cycle.sensors.board.absent ? Axes{0, 1, 0} : robot_up_.up();
  if (!up || (wanted_ == Resync::kTurned && !robot_up_.isSteady())) {
    status_.state = LiveState::kSettling;
    return;
  }
  std::array<double, kJoints> pose = measured_rad_;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (std::isnan(pose[i])) pose[i] = cycle.sensors.joint[i].commanded.value;
    if (std::isnan(pose[i])) pose[i] = 0;
  }
  status_.up = alongAxis(*up);
  if (!twin_.place(cycle, pose, *status_.up)) {
    status_.state = LiveState::kOnItsSide;
    return;
  }
  status_.state = LiveState::kSettling;
  status_.resynced = wanted_;
  ++status_.resyncs[static_cast<std::size_t>(*wanted_)];
  wanted_.reset();
  turned_s_ = 0;
  twin_up_.forget();
  settled_at_s_ = last_time_s_ + kSettle;
}

void LiveComparison::compare(const Sensors& seen, const BodyState& twin) {
  ++status_.compared;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    const bool is_compared = joint.driven && joint.motion.fresh();
    position_[i].add(is_compared ? joint.position.value - twin.joint[i].position_rad : kNone);
    load_[i].add(is_compared ? joint.load - twin.joint[i].load : kNone);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_fresh = seen.board.motion.fresh();
    gyro_[i].add(is_fresh ? seen.board.gyro[i].value - twin.gyro_rad_s[i] : kNone);
    accel_[i].add(is_fresh ? seen.board.accelerometer[i].value - twin.accel_m_s2[i] : kNone);
  }
}

LiveReport LiveComparison::report() const {
  LiveReport out = status_;
  for (std::size_t i = 0; i < kJoints; ++i) {
    out.position_rad[i] = position_[i].get();
    out.load[i] = load_[i].get();
  }
  for (std::size_t i = 0; i < 3; ++i) {
    out.gyro_rad_s[i] = gyro_[i].get();
    out.accel_m_s2[i] = accel_[i].get();
  }
  return out;
}

}  // namespace darwinop::gap::live
