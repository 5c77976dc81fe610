#include "safety/supply_watch.hpp"

#include <algorithm>

namespace darwinop::safety {

SupplyWatch::SupplyWatch(bool held_before) {
  if (!held_before) return;
  limited_.set();
  missed_.set();
}

void SupplyWatch::update(const Sensors& seen, Nanos dt) noexcept {
  restarted_now_ = polled_now_ = false;
  since_restart_ = std::min(since_restart_ + dt, kTogether);
  if (since_restart_ >= kTogether) restarted_.reset();
  Joints there;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    there[i] = joint.motion.age <= kAnswerPatience;
    if (!joint.motion.fresh())
      missed_.set(i);
    else if (joint.polled.fresh())
      notePoll(i, joint);
  }
  const std::size_t of = ((limited_ | restarted_) & there).count();
  interrupted_now_ = restarted_now_ && 2 * (restarted_ & there).count() >= of;
  if (polled_now_) measureVoltage(seen);
}

/// A reply that was missed before shows nothing about what is written now.
void SupplyWatch::noteGoals(const std::bitset<kJoints>& written) noexcept {
  missed_ &= ~written | limited_;
  limited_ |= written;
}

/// A starting servo has neither torque nor a speed limit, and no goal without one is ever written. It boots for 0.2 s,
/// so it has missed replies: a single damaged reading is not a restart.
void SupplyWatch::notePoll(std::size_t joint, const JointSensors& seen) noexcept {
  polled_now_ = true;
  if (seen.speed_limit.value > 0 || seen.torque_enabled) {
    limited_.set(joint);
    missed_.reset(joint);
  } else if (limited_[joint]) {
    limited_.reset(joint);
    if (!missed_[joint]) return;  // the goal was lost
    restarted_.set(joint);
    restarted_now_ = true;
    since_restart_ = Nanos{0};
  }
}

void SupplyWatch::measureVoltage(const Sensors& seen) noexcept {
  std::array<double, kJoints> volts{};
  std::size_t count = 0;
  for (const JointSensors& joint : seen.joint)
    if (joint.polled.age <= kRecent && joint.voltage.known()) volts[count++] = joint.voltage.value;
  voltage_ = kUnknown;
  if (count == 0) return;
  const auto middle = volts.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(volts.begin(), middle, volts.begin() + static_cast<std::ptrdiff_t>(count));
  voltage_ = *middle;
}

}  // namespace darwinop::safety
