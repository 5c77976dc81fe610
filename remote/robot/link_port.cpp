// RobotPort on a runtime::RobotLink: converts requests to the commands that a local controller would give.
#include "remote/robot/link_port.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/counts.hpp"
#include "remote/protocol/units.hpp"
#include "runtime/exchange_link.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kDeadLoop{1'000'000'000};     // without a cycle: the loop counts as dead; longer than any period
constexpr Nanos kLongestStep{500'000'000};    // between two requests; the lease is given back after that
constexpr double kAtRest = 0.1;               // rad: maximum distance of a joint at rest from its goal, under any load
constexpr std::uint32_t kMaxPositionAge = 3;  // cycles: an older position may be far off
constexpr std::atomic<bool> kNever{false};

std::string faultText(const SafetyReport& report) {
  const FaultRow& fault = row(report.worst);
  std::string text{fault.meaning};
  if (report.worst_joint >= 1 && report.worst_joint <= kJoints)
    text += " (" + std::string{kJointTable[report.worst_joint - 1U].name} + ")";
  return text + "; " + std::string{fault.remedy};
}

/// Value in the panel's register.
std::uint8_t panelBit(Led led) {
  return led == Led::kBackRed ? 1 : led == Led::kBackBlue ? 2 : 4;
}

}  // namespace

LinkPort::LinkPort(Home home, Connect connect, bool start_where_it_is)
    : home_{home}, connect_{std::move(connect)}, start_where_it_is_{start_where_it_is} {
  clearCommands();
  if (home_ == Home::kEmbedded) link_ = connect_();
}

void LinkPort::clearCommands() {
  motors_.clear();
  for (std::size_t i = 0; i < kJoints; ++i) motors_.emplace_back(static_cast<Joint>(i));
  commands_ = {};
}

void LinkPort::startSession(SessionStart start) {
  const bool again = start == SessionStart::kResumed;
  if (home_ == Home::kDaemon) {
    link_ = connect_();
  } else if (had_session_) {
    // For safety this is a new driver, as after a change of the lease.
    if (auto* const exchange = dynamic_cast<runtime::ExchangeLink*>(link_.get())) exchange->beginSession();
  }
  had_session_ = true;
  if (!again) clearCommands();
  commands_.start_where_it_is = again || start_where_it_is_;
  commands_.unattended = again;
  // The present cycle may have started before this session: only images of later cycles refer to it.
  last_cycle_ = link_->sensors().cycle;
  first_session_cycle_ = last_cycle_ + 2;
  applied_at_ = last_cycle_at_ = simulated_at_ = clock_.now();
}

/// For safety a session starts with its first commands, so none has started yet.
void LinkPort::cancelSession() noexcept {
  if (home_ == Home::kDaemon) link_.reset();
}

void LinkPort::apply(const Request& request) {
  for (const LedSetting& led : request.leds) applyLed(led);
  for (const MotorSetting& motor : request.motors) applyMotor(motor);
  const Nanos now = clock_.now();
  const double dt_s = std::chrono::duration<double>(std::min(now - applied_at_, kLongestStep)).count();
  applied_at_ = now;
  const Sensors seen = link_->sensors();
  for (std::size_t i = 0; i < kJoints; ++i) commands_.joint[i] = motors_[i].command(seen.joint[i], dt_s);
  if (request.extended) {
    commands_.start_where_it_is |= request.extension.start_where_it_is;
    commands_.fault_resets = request.extension.fault_resets;
    commands_.unattended |= request.extension.unattended;
  }
  link_->publish(commands_);
  if (link_->realTime()) return;
  if (request.extended)
    simulateUntil(request.extension.until_cycle);
  else
    simulate();
}

void LinkPort::publish(const Commands& commands) {
  commands_.joint = commands.joint;
  commands_.led = commands.led;
  link_->publish(commands_);
  if (!link_->realTime()) simulate();
}

void LinkPort::applyMotor(const MotorSetting& setting) {
  using M = MotorSetting;
  goals::MotorControl& motor = motors_[index(setting.joint)];
  if (setting.has(M::kPosition) && isEncoderPosition(setting.position))
    motor.setPosition(positionFromWire(setting.position));
  if (setting.has(M::kVelocity)) motor.setVelocity(velocityFromWire(setting.velocity));
  if (setting.has(M::kAcceleration)) motor.setAcceleration(accelerationFromWire(setting.acceleration));
  if (setting.has(M::kAvailableTorque)) motor.setAvailableTorque(torqueFromWire(setting.available_torque));
  if (setting.has(M::kPid) && setting.pid[0] >= 0) motor.setPGain(gainFromWire(setting.pid[0]));
  if (setting.has(M::kTorque)) motor.setTorque(torqueFromWire(setting.torque));
}

void LinkPort::applyLed(const LedSetting& setting) {
  LedCommand& led = commands_.led;
  const int colour = static_cast<int>(setting.colour);
  if (setting.led == Led::kEye) return led.setEye(rgb15From24(colour));
  if (setting.led == Led::kHead) return led.setHead(rgb15From24(colour));
  // The three back LEDs share one register: the other two keep their commanded or their present state.
  const int others = led.has(LedCommand::kPanel) ? led.panel : link_->sensors().board.led_panel;
  const int bit = panelBit(setting.led);
  led.setPanel(static_cast<std::uint8_t>(colour == 1 ? others | bit : others & ~bit));
}

/// In lockstep the server runs the cycles: as many as real time has passed, at least one.
void LinkPort::simulate() {
  const Nanos now = clock_.now();
  const Nanos elapsed = std::min(now - simulated_at_, kLongestStep);
  simulated_at_ = now;
  const auto cycles = std::max<Nanos::rep>(1, elapsed / link_->period());
  (void)link_->waitForCycle(link_->sensors().cycle + static_cast<std::uint64_t>(cycles), kNever);
}

/// A client with the extension names the cycle, so that runs are repeatable on any network and machine.
void LinkPort::simulateUntil(std::uint64_t cycle) {
  const std::uint64_t now = link_->sensors().cycle;
  const auto most = static_cast<std::uint64_t>(kLongestStep / link_->period());
  if (cycle > now) (void)link_->waitForCycle(std::min(cycle, now + most), kNever);
}

void LinkPort::waitForNextCycle() {
  (void)link_->waitForCycle(link_->sensors().cycle + 1, kNever);
}

std::string LinkPort::endReason() {
  const Sensors seen = link_->sensors();
  const Nanos now = clock_.now();
  if (seen.cycle != last_cycle_) {
    last_cycle_ = seen.cycle;
    last_cycle_at_ = now;
  }
  if (seen.cycle >= first_session_cycle_ && seen.safety.controller_must_end) return faultText(seen.safety);
  // Returns at once for a finished cycle, and fails if the loop has ended.
  if (!link_->waitForCycle(seen.cycle, kNever)) return link_->whyEnded();
  if (link_->realTime() && now - last_cycle_at_ > kDeadLoop)
    return "the robot's loop has not run a cycle for 1 s; check it with: darwinop runtime --status";
  return {};
}

void LinkPort::hold() noexcept {
  const Sensors seen = link_->sensors();
  for (std::size_t i = 0; i < kJoints; ++i)
    if (const Rad rest = holdPosition(seen, i); rest.known()) commands_.joint[i].setGoal(rest);
  // Safety holds a silent driver only after stall_ms, and lets a slow joint continue to its goal; this holds at once.
  link_->publish(commands_);
  if (home_ == Home::kEmbedded) return;
  link_->leaveHolding();
  link_.reset();
}

void LinkPort::endAbandonedSession() noexcept try {
  if (home_ == Home::kEmbedded || !had_session_ || link_)
    return;  // a client that drives: the link's destructor ends the session
  link_ = connect_();
  // The client's last commands may not be in the image yet.
  if (!link_->waitForCycle(link_->sensors().cycle + 2, kNever)) return link_.reset();
  const State state = link_->sensors().safety.state;
  commands_.start_where_it_is = commands_.unattended = true;
  const bool at_rest = !drives(state) || state == State::kKneeling;
  if (!at_rest) link_->publish(commands_);  // without commands the session does not start, so it does not end either
  link_.reset();
} catch (const std::exception&) {
  return;  // another process drives, or no loop runs
}

void LinkPort::endSession() noexcept {
  commands_.end_of_session = true;
  link_->publish(commands_);
  commands_.end_of_session = false;
  if (home_ == Home::kDaemon) link_.reset();  // the link's destructor ends the session once more
}

/// Position at which to hold a joint; unknown if it has no goal.
Rad LinkPort::holdPosition(const Sensors& seen, std::size_t joint) const {
  const JointSensors& now = seen.joint[joint];
  const bool to_start_pose = seen.safety.state != State::kDriven && !commands_.start_where_it_is;
  if (to_start_pose) return radFromTicks(kJointTable[joint].start);  // every session starts with a move there
  const bool on_the_way =
      std::abs(now.commanded.value - now.position.value) > kAtRest && now.motion.age <= kMaxPositionAge;
  return on_the_way ? now.position : now.commanded;
}

}  // namespace darwinop::remote
