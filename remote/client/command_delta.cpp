// Converts commands to requests: each command once, when it changes.
#include "remote/client/command_delta.hpp"

#include <algorithm>
#include <cmath>

#include "core/counts.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::remote {
namespace {

// NaN becomes kNoValue, which the server ignores: the joint keeps its goal.
std::int32_t goalOnWire(Rad goal) {
  return std::isnan(goal.value) ? kNoValue : cut(std::round(std::clamp(goal.value, -kPi, kPi) * 2048 / kPi));
}
std::int32_t speedOnWire(RadPerSec speed) {
  return cut(std::round(std::min(std::abs(speed.value) / kRadPerSecPerCount, double{kSpeedMax})));
}
/// 0 would switch torque off. A limit that is not finite is ignored, as in safety: the joint keeps its limit.
std::int32_t torqueOnWire(const JointCommand& wanted) {
  if (!wanted.torque_on) return 0;
  const double limit = wanted.has(JointCommand::kTorqueLimit) ? wanted.torque_limit.value : kMaxTorqueNm;
  if (!std::isfinite(limit)) return kNoValue;
  return std::max(1, cut(std::round(limit * kTorqueMax / kMaxTorqueNm)));
}

MotorSetting settingOf(Joint joint, const JointCommand& wanted) {
  using M = MotorSetting;
  MotorSetting setting{.joint = joint};
  const auto set = [&setting](M::Bit bit, std::int32_t& field, std::int32_t value) {
    if (value == kNoValue) return;
    field = value;
    setting.set |= bit;
  };
  // The highest tick is 2047; pi would be 2048, outside the encoder's range.
  if (wanted.has(JointCommand::kGoal)) {
    const std::int32_t goal = goalOnWire(wanted.goal);
    set(M::kPosition, setting.position, goal == 2048 ? 2047 : goal);
  }
  if (wanted.has(JointCommand::kSpeedLimit)) set(M::kVelocity, setting.velocity, speedOnWire(wanted.speed_limit));
  if (wanted.has(JointCommand::kTorque) || wanted.has(JointCommand::kTorqueLimit)) {
    JointCommand torque = wanted;
    torque.torque_on = !wanted.has(JointCommand::kTorque) || wanted.torque_on;
    set(M::kAvailableTorque, setting.available_torque, torqueOnWire(torque));
  }
  if (wanted.has(JointCommand::kPGain))
    set(M::kPid, setting.pid[0], cut(std::round(std::min(wanted.p_gain, kMaxPGain) * 1000)));
  return setting;
}

/// The fields of `now` that differ from `sent`; updates `sent`.
MotorSetting changesOf(const MotorSetting& now, MotorSetting& sent) {
  using M = MotorSetting;
  MotorSetting changes{.joint = now.joint};
  const auto compare = [&](M::Bit bit, auto field) {
    if (!now.has(bit) || (sent.has(bit) && sent.*field == now.*field)) return;
    changes.set |= bit;
    changes.*field = sent.*field = now.*field;
    sent.set |= bit;
  };
  compare(M::kPosition, &M::position);
  compare(M::kVelocity, &M::velocity);
  compare(M::kAvailableTorque, &M::available_torque);
  compare(M::kPid, &M::pid);
  return changes;
}

}  // namespace

void CommandDelta::add(const Commands& wanted, Request& request) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const MotorSetting changes = changesOf(settingOf(static_cast<Joint>(i), wanted.joint[i]), sent_[i]);
    if (changes.set != 0) (void)request.motors.add(changes);
  }
  addLeds(wanted.led, request);
}

void CommandDelta::addLeds(const LedCommand& wanted, Request& request) {
  const auto is_changed = [&](LedCommand::Bit bit, auto field) {
    if (!wanted.has(bit) || (led_.has(bit) && led_.*field == wanted.*field)) return false;
    led_.*field = wanted.*field;
    led_.set |= bit;
    return true;
  };
  const auto colour = [&](Led led, int value) { (void)request.leds.add({led, static_cast<std::uint32_t>(value)}); };
  if (is_changed(LedCommand::kEye, &LedCommand::eye)) colour(Led::kEye, rgb24From15(wanted.eye));
  if (is_changed(LedCommand::kHead, &LedCommand::head)) colour(Led::kHead, rgb24From15(wanted.head));
  if (!is_changed(LedCommand::kPanel, &LedCommand::panel)) return;
  colour(Led::kBackRed, (wanted.panel & 1) != 0 ? 1 : 0);
  colour(Led::kBackGreen, (wanted.panel & 4) != 0 ? 1 : 0);
  colour(Led::kBackBlue, (wanted.panel & 2) != 0 ? 1 : 0);
}

}  // namespace darwinop::remote
