// What a controller wants, as the wire says it: each wish once, when it changes.
#include "remote/client/wishes.hpp"

#include <algorithm>
#include <cmath>

#include "remote/protocol/units.hpp"

namespace darwinop::remote {
namespace {

// A value that is no number becomes kNoValue, which the server overhears: the joint keeps the wish that it had.
std::int32_t goalOnWire(Rad goal) {
  return std::isnan(goal.value) ? kNoValue : cut(std::round(std::clamp(goal.value, -kPi, kPi) * 2048 / kPi));
}
std::int32_t speedOnWire(RadPerSec speed) {
  return cut(std::round(std::abs(speed.value) * 30.0 / (0.114 * kPi)));
}
/// 0 would let the joint go. A limit that is not finite is none, as for safety: the joint keeps the one that it had.
std::int32_t torqueOnWire(const JointCommand& wanted) {
  if (!wanted.torque_on) return 0;
  const double limit = wanted.has(JointCommand::kTorqueLimit) ? wanted.torque_limit.value : kMaxTorqueNm;
  if (!std::isfinite(limit)) return kNoValue;
  return std::max(1, cut(std::round(limit * kTorqueMax / kMaxTorqueNm)));
}

MotorSetting settingOf(Joint joint, const JointCommand& wanted) {
  using M = MotorSetting;
  MotorSetting setting{.joint = joint};
  const auto say = [&setting](M::Bit bit, std::int32_t& field, std::int32_t value) {
    if (value == kNoValue) return;
    field = value;
    setting.set |= bit;
  };
  // The highest tick is 2047: pi itself is one further, and no encoder knows it.
  if (wanted.has(JointCommand::kGoal)) {
    const std::int32_t goal = goalOnWire(wanted.goal);
    say(M::kPosition, setting.position, goal == 2048 ? 2047 : goal);
  }
  if (wanted.has(JointCommand::kSpeedLimit)) say(M::kVelocity, setting.velocity, speedOnWire(wanted.speed_limit));
  if (wanted.has(JointCommand::kTorque) || wanted.has(JointCommand::kTorqueLimit)) {
    JointCommand torque = wanted;
    torque.torque_on = !wanted.has(JointCommand::kTorque) || wanted.torque_on;
    say(M::kAvailableTorque, setting.available_torque, torqueOnWire(torque));
  }
  if (wanted.has(JointCommand::kPGain)) say(M::kPid, setting.pid[0], cut(std::round(wanted.p_gain * 1000)));
  return setting;
}

/// `now` without what was told before; that is noted.
MotorSetting newsOf(const MotorSetting& now, MotorSetting& told) {
  using M = MotorSetting;
  MotorSetting news{.joint = now.joint};
  const auto look = [&](M::Bit bit, auto field) {
    if (!now.has(bit) || (told.has(bit) && told.*field == now.*field)) return;
    news.set |= bit;
    news.*field = told.*field = now.*field;
    told.set |= bit;
  };
  look(M::kPosition, &M::position);
  look(M::kVelocity, &M::velocity);
  look(M::kAvailableTorque, &M::available_torque);
  look(M::kPid, &M::pid);
  return news;
}

int wideColour(std::uint16_t word) {
  const auto widen = [](int five) { return (five << 3) | (five >> 2); };
  return (widen(word & 31) << 16) | (widen((word >> 5) & 31) << 8) | widen((word >> 10) & 31);
}

}  // namespace

void Wishes::add(const Commands& wanted, Request& request) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const MotorSetting news = newsOf(settingOf(static_cast<Joint>(i), wanted.joint[i]), told_[i]);
    if (news.set != 0) (void)request.motors.add(news);
  }
  addLeds(wanted.led, request);
}

void Wishes::addLeds(const LedCommand& wanted, Request& request) {
  const auto is_news = [&](LedCommand::Bit bit, auto field) {
    if (!wanted.has(bit) || (led_.has(bit) && led_.*field == wanted.*field)) return false;
    led_.*field = wanted.*field;
    led_.set |= bit;
    return true;
  };
  const auto colour = [&](Led led, int value) { (void)request.leds.add({led, static_cast<std::uint32_t>(value)}); };
  if (is_news(LedCommand::kEye, &LedCommand::eye)) colour(Led::kEye, wideColour(wanted.eye));
  if (is_news(LedCommand::kHead, &LedCommand::head)) colour(Led::kHead, wideColour(wanted.head));
  if (!is_news(LedCommand::kPanel, &LedCommand::panel)) return;
  colour(Led::kBackRed, (wanted.panel & 1) != 0 ? 1 : 0);
  colour(Led::kBackGreen, (wanted.panel & 4) != 0 ? 1 : 0);
  colour(Led::kBackBlue, (wanted.panel & 2) != 0 ? 1 : 0);
}

}  // namespace darwinop::remote
