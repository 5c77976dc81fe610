// RobotPort on a runtime::RobotLink: converts requests to the commands that a local controller would give.
#include "remote/robot/link_port.hpp"

#include <algorithm>

#include "core/counts.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kDeadLoop{1'000'000'000};   // without a cycle: the loop counts as dead; longer than any period
constexpr Nanos kLongestStep{500'000'000};  // between two requests; the lease is given back after that

/// Value in the panel's register.
std::uint8_t panelBit(Led led) {
  return led == Led::kBackRed ? 1 : led == Led::kBackBlue ? 2 : 4;
}

}  // namespace

LinkPort::LinkPort(Home home, Connect connect, bool start_where_it_is)
    : home_{home}, connect_{std::move(connect)}, start_where_it_is_{start_where_it_is} {
  clearCommands();
  if (home_ == Home::kEmbedded) session_.emplace(connect_());
}

void LinkPort::clearCommands() {
  motors_.clear();
  for (std::size_t i = 0; i < kJoints; ++i) motors_.emplace_back(static_cast<Joint>(i));
  commands_ = {};
}

void LinkPort::startSession(SessionStart start) {
  const bool again = start == SessionStart::kResumed;
  if (home_ == Home::kDaemon) session_.emplace(connect_());
  session_->start();
  is_commanded_ = false;
  end_request_.clear();
  if (!again) clearCommands();
  commands_.start_where_it_is = again || start_where_it_is_;
  commands_.unattended = again;
  last_cycle_ = session_->sensors().cycle;
  applied_at_ = last_cycle_at_ = simulated_at_ = clock_.now();
}

/// For safety a session starts with its first commands, so none has started yet.
void LinkPort::cancelSession() noexcept {
  if (home_ == Home::kDaemon) session_.reset();
}

void LinkPort::apply(const Request& request) {
  for (const LedSetting& led : request.leds) applyLed(led);
  for (const MotorSetting& motor : request.motors) applyMotor(motor);
  const Nanos now = clock_.now();
  const double dt_s = std::chrono::duration<double>(std::min(now - applied_at_, kLongestStep)).count();
  applied_at_ = now;
  const Sensors seen = session_->sensors();
  const auto usual_gain = static_cast<double>(seen.safety.default_p_gain);
  for (std::size_t i = 0; i < kJoints; ++i) commands_.joint[i] = motors_[i].command(seen.joint[i], usual_gain, dt_s);
  if (request.extended) {
    commands_.start_where_it_is |= request.extension.start_where_it_is;
    commands_.fault_resets = request.extension.fault_resets;
    commands_.unattended |= request.extension.unattended;
  }
  session_->publish(commands_);
  is_commanded_ = true;
  if (session_->link().realTime()) return;
  if (request.extended)
    simulateUntil(request.extension.until_cycle);
  else
    simulate();
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
  const int others = led.has(LedCommand::kPanel) ? led.panel : session_->sensors().board.led_panel;
  const int bit = panelBit(setting.led);
  led.setPanel(static_cast<std::uint8_t>(colour == 1 ? others | bit : others & ~bit));
}

/// In lockstep the server runs the cycles: as many as real time has passed, at least one.
void LinkPort::simulate() {
  const Nanos now = clock_.now();
  const Nanos elapsed = std::min(now - simulated_at_, kLongestStep);
  simulated_at_ = now;
  const auto cycles = std::max<Nanos::rep>(1, elapsed / session_->link().period());
  (void)session_->waitForCycle(session_->sensors().cycle + static_cast<std::uint64_t>(cycles));
}

/// A client with the extension names the cycle, so that runs are repeatable on any network and machine.
void LinkPort::simulateUntil(std::uint64_t cycle) {
  const std::uint64_t now = session_->sensors().cycle;
  const auto most = static_cast<std::uint64_t>(kLongestStep / session_->link().period());
  if (cycle > now) (void)session_->waitForCycle(std::min(cycle, now + most));
}

std::string LinkPort::endReason() {
  const Sensors seen = session_->sensors();
  const Nanos now = clock_.now();
  if (seen.cycle != last_cycle_) {
    last_cycle_ = seen.cycle;
    last_cycle_at_ = now;
  }
  if (std::string why = session_->faultEnd(seen); !why.empty()) return why;
  if (std::string why = session_->loopEnd(seen); !why.empty()) {
    if (!session_->loopEnd(seen).empty()) return why;
    end_request_ = why;  // requested once, while the loop runs on for the last steps
  }
  if (session_->link().realTime() && now - last_cycle_at_ > kDeadLoop) return kNoCycle;
  return {};
}

void LinkPort::hold() noexcept {
  // Without commands, and in the cycle of the first ones, images still have the number of an earlier session.
  const Sensors seen = session_->sensors();
  if (is_commanded_) held_session_ = seen.cycle >= session_->firstCycle() ? seen.safety.session : 0;
  session_->hold(commands_);
  if (home_ == Home::kDaemon) session_.reset();
}

void LinkPort::endAbandonedSession() noexcept try {
  if (home_ == Home::kEmbedded || held_session_ == 0 || session_)
    return;  // a client that drives: the link's destructor ends the session
  session_.emplace(connect_());
  session_->start();
  // The client's last commands may not be in the image yet.
  if (!session_->waitForCycle(session_->firstCycle())) return session_.reset();
  const SafetyReport report = session_->sensors().safety;
  commands_.start_where_it_is = commands_.unattended = true;
  const bool at_rest = !drives(report.state) || report.state == State::kKneeling;
  const bool is_ours = report.session == held_session_;  // otherwise another program left the robot as it is
  // Without commands the session does not start, so it does not end either.
  if (is_ours && !at_rest) session_->publish(commands_);
  session_.reset();
} catch (const std::exception&) {
  return;  // another process drives, or no loop runs
}

void LinkPort::endSession() noexcept {
  session_->end(commands_);
  held_session_ = 0;
  if (home_ == Home::kDaemon) session_.reset();  // the link's destructor ends the session once more
}

}  // namespace darwinop::remote
