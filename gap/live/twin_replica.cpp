#include "gap/live/twin_replica.hpp"

#include <cmath>
#include <limits>

#include "core/servo_limits.hpp"
#include "gap/case/wire_schedule.hpp"

namespace darwinop::gap::live {
namespace {

/// Noise differs each time, and the voltage that the robot measures has sagged already.
twin::Model withoutNoiseAndSag(twin::Model model) {
  model.imu.gyro_noise_rad_s = model.imu.accel_noise_m_s2 = model.body.battery_resistance_ohm = 0;
  return model;
}

constexpr double kBytesPerNs = 1e-9 / wire::kByte;

CycleSchedule scheduleOf(const Sensors& seen) {
  std::array<double, kJoints> replies{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    if (joint.motion.fresh()) replies[i] = joint.polled.fresh() ? wire::kOfPolled : wire::kOfServo;
  }
  return cycleSchedule(static_cast<double>(seen.wire.wire_ns) * kBytesPerNs, replies);
}

std::int64_t nanos(double seconds) {
  return std::llround(seconds * 1e9);
}

/// When the cycle began.
std::int64_t beginOf(const Sensors& seen) {
  return seen.time_ns + seen.wake_latency_ns;
}

}  // namespace

TwinReplica::TwinReplica(twin::Model model, Support support) : support_{support} {
  twin::RobotBodyOptions options{.ball = twin::Ball::kNone};
  if (support == Support::kClamped) options.clamped_up = twin::ClampedUp{0, 1, 0};
  body_ = std::make_unique<twin::RobotBody>(withoutNoiseAndSag(std::move(model)), options);
}

bool TwinReplica::place(const LiveCycle& cycle, const std::array<double, kJoints>& pose_rad, const Axes& up) {
  double lean = 0;
  if (support_ == Support::kFloor) {
    const std::optional<double> pitch = forwardLean(up);
    if (!pitch) return false;
    lean = *pitch;
  } else if (!body_->clamp(up)) {
    return false;
  }
  body_->place(pose_rad, lean);
  now_ns_ = beginOf(cycle.sensors) + nanos(scheduleOf(cycle.sensors).written_s);
  command(cycle, pose_rad);
  return true;
}

const BodyState& TwinReplica::step(const LiveCycle& cycle, const std::array<double, kJoints>& measured_rad) {
  const CycleSchedule schedule = scheduleOf(cycle.sensors);
  const std::int64_t begin = beginOf(cycle.sensors);
  advanceTo(begin + nanos(schedule.written_s));
  command(cycle, measured_rad);
  advanceTo(begin + nanos(schedule.board_s));
  readings_.gyro_rad_s = body_->state().gyro_rad_s;
  readings_.accel_m_s2 = body_->state().accel_m_s2;
  for (std::size_t i = 0; i < kJoints; ++i) {
    advanceTo(begin + nanos(schedule.servo_s[i]));
    readings_.joint[i] = body_->state().joint[i];
  }
  return readings_;
}

void TwinReplica::advanceTo(std::int64_t time_ns) {
  if (time_ns <= now_ns_) return;
  body_->step(Nanos{time_ns - now_ns_}, drives_);
  now_ns_ = time_ns;
}

void TwinReplica::command(const LiveCycle& cycle, const std::array<double, kJoints>& measured_rad) {
  const Volt supply = cycle.sensors.board.voltage;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = cycle.sensors.joint[i];
    ServoDrive& drive = drives_[i];
    const double goal = joint.driven ? joint.commanded.value : measured_rad[i];
    drive.torque_on = !std::isnan(goal);
    if (drive.torque_on) drive.goal_rad = goal;
    const double speed = joint.speed_limit.value;  // NaN before the first poll
    drive.speed_limit_rad_s = joint.driven && speed > 0 ? speed : std::numeric_limits<double>::infinity();
    const double torque = joint.torque_limit.value;
    drive.torque_limit = joint.driven && torque >= 0 ? torque / kMaxTorqueNm : 1;
    drive.p_gain = joint.driven && cycle.p_gain[i] >= 0 ? cycle.p_gain[i] : kDefaultPGain;
    if (supply.value > 0) drive.supply_v = supply.value;
  }
}

}  // namespace darwinop::gap::live
