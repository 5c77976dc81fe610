// The robot of a controller's link, for the server: what the wire says becomes commands as a controller's would.
#include "remote/robot/link_port.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/counts.hpp"
#include "remote/protocol/units.hpp"
#include "runtime/exchange_link.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kDeadLoop{1'000'000'000};   // without a cycle: longer than any period
constexpr Nanos kLongestStep{500'000'000};  // between two requests; after more the lease is gone
constexpr double kAtRest = 0.1;             // rad: a joint at rest is nearer to its goal, whatever hangs on it
constexpr std::uint32_t kBelieved = 3;      // cycles: a position that is older may be far off
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
  forgetWishes();
  if (home_ == Home::kOwn) link_ = connect_();
}

void LinkPort::forgetWishes() {
  motors_.clear();
  for (std::size_t i = 0; i < kJoints; ++i) motors_.emplace_back(static_cast<Joint>(i));
  commands_ = {};
}

void LinkPort::begin(Beginning beginning) {
  const bool again = beginning == Beginning::kAgain;
  if (home_ == Home::kDaemon) {
    link_ = connect_();
  } else if (used_) {
    // Safety meets a driver that it does not know, as it would after a lease that changed hands.
    if (auto* const exchange = dynamic_cast<runtime::ExchangeLink*>(link_.get())) exchange->beginSession();
  }
  used_ = true;
  if (!again) forgetWishes();
  commands_.start_where_it_is = again || start_where_it_is_;
  commands_.unattended = again;
  // The cycle under way may have begun before the first image was there: only the one after it speaks of us.
  last_cycle_ = link_->sensors().cycle;
  first_of_ours_ = last_cycle_ + 2;
  obeyed_ = last_cycle_at_ = simulated_ = clock_.now();
}

/// Safety knows a driver from its first commands on only.
void LinkPort::leaveAlone() noexcept {
  if (home_ == Home::kDaemon) link_.reset();
}

void LinkPort::obey(const Request& request) {
  for (const LedSetting& led : request.leds) light(led);
  for (const MotorSetting& motor : request.motors) listenTo(motor);
  const Nanos now = clock_.now();
  const double dt_s = std::chrono::duration<double>(std::min(now - obeyed_, kLongestStep)).count();
  obeyed_ = now;
  const Sensors seen = link_->sensors();
  for (std::size_t i = 0; i < kJoints; ++i) commands_.joint[i] = motors_[i].command(seen.joint[i], dt_s);
  if (request.extended) {
    commands_.start_where_it_is |= request.extension.start_where_it_is;
    commands_.fault_resets = request.extension.fault_resets;
    commands_.unattended |= request.extension.unattended;
  }
  link_->publish(commands_);
  if (!link_->realTime()) simulate(request);
}

void LinkPort::listenTo(const MotorSetting& setting) {
  using M = MotorSetting;
  MotorControl& motor = motors_[index(setting.joint)];
  if (setting.has(M::kPosition) && isEncoderPosition(setting.position))
    motor.setPosition(positionFromWire(setting.position));
  if (setting.has(M::kVelocity)) motor.setVelocity(velocityFromWire(setting.velocity));
  if (setting.has(M::kAcceleration)) motor.setAcceleration(accelerationFromWire(setting.acceleration));
  if (setting.has(M::kAvailableTorque)) motor.setAvailableTorque(torqueFromWire(setting.available_torque));
  if (setting.has(M::kPid) && setting.pid[0] >= 0) motor.setPGain(gainFromWire(setting.pid[0]));
  if (setting.has(M::kTorque)) motor.setTorque(torqueFromWire(setting.torque));
}

void LinkPort::light(const LedSetting& setting) {
  LedCommand& led = commands_.led;
  const int colour = static_cast<int>(setting.colour);
  if (setting.led == Led::kEye) return led.setEye(rgb15From24(colour));
  if (setting.led == Led::kHead) return led.setHead(rgb15From24(colour));
  // The three back LEDs share one register: the others stay as they were asked for, or as the board shows them.
  const int others = led.has(LedCommand::kPanel) ? led.panel : link_->sensors().board.led_panel;
  const int bit = panelBit(setting.led);
  led.setPanel(static_cast<std::uint8_t>(colour == 1 ? others | bit : others & ~bit));
}

/// In lockstep nobody else runs the cycles: as many as time has gone by, at least one.
void LinkPort::simulate(const Request& request) {
  if (request.extended) return simulateUntil(request.extension.until_cycle);
  const Nanos now = clock_.now();
  const Nanos gone_by = std::min(now - simulated_, kLongestStep);
  simulated_ = now;
  const auto cycles = std::max<Nanos::rep>(1, gone_by / link_->period());
  (void)link_->waitForCycle(link_->sensors().cycle + static_cast<std::uint64_t>(cycles), kNever);
}

/// Our own client says how far: its run is the same every time, however fast the network and the machines are.
void LinkPort::simulateUntil(std::uint64_t cycle) {
  const std::uint64_t now = link_->sensors().cycle;
  const auto most = static_cast<std::uint64_t>(kLongestStep / link_->period());
  if (cycle > now) (void)link_->waitForCycle(std::min(cycle, now + most), kNever);
}

void LinkPort::waitForNextCycle() {
  (void)link_->waitForCycle(link_->sensors().cycle + 1, kNever);
}

std::string LinkPort::mustEnd() {
  const Sensors seen = link_->sensors();
  const Nanos now = clock_.now();
  if (seen.cycle != last_cycle_) {
    last_cycle_ = seen.cycle;
    last_cycle_at_ = now;
  }
  if (seen.cycle >= first_of_ours_ && seen.safety.controller_must_end) return faultText(seen.safety);
  // A cycle that is finished is not waited for; whether the loop goes on is looked at all the same.
  if (!link_->waitForCycle(seen.cycle, kNever)) return link_->whyEnded();
  if (link_->realTime() && now - last_cycle_at_ > kDeadLoop)
    return "the robot's loop has not run a cycle for 1 s; look at it with: darwinop runtime --status";
  return {};
}

void LinkPort::hold() noexcept {
  const Sensors seen = link_->sensors();
  for (std::size_t i = 0; i < kJoints; ++i)
    if (const Rad rest = restingPlace(seen, i); rest.known()) commands_.joint[i].setGoal(rest);
  // Safety holds within stall_ms what is silent, but lets a slow joint go on to its goal; this is at once, and here.
  link_->publish(commands_);
  if (home_ == Home::kOwn) return;
  link_->leaveHolding();
  link_.reset();
}

void LinkPort::farewellForWhoLeft() noexcept try {
  if (home_ == Home::kOwn || !used_ || link_) return;  // who drives says it when the link goes
  link_ = connect_();
  // What the client wished for last may not be seen yet.
  if (!link_->waitForCycle(link_->sensors().cycle + 2, kNever)) return link_.reset();
  const State state = link_->sensors().safety.state;
  commands_.start_where_it_is = commands_.unattended = true;
  const bool at_rest = !drives(state) || state == State::kKneeling;
  if (!at_rest) link_->publish(commands_);  // who never spoke says none
  link_.reset();
} catch (const std::exception&) {
  return;  // somebody else drives, or no loop runs: the robot is in other hands
}

void LinkPort::farewell() noexcept {
  commands_.farewell = true;
  link_->publish(commands_);
  commands_.farewell = false;
  if (home_ == Home::kDaemon) link_.reset();  // says it once more
}

/// Where a joint is to stay, or not known: it has no goal, so it needs no other one.
Rad LinkPort::restingPlace(const Sensors& seen, std::size_t joint) const {
  const JointSensors& now = seen.joint[joint];
  const bool to_start_pose = seen.safety.state != State::kDriven && !commands_.start_where_it_is;
  if (to_start_pose) return radFromTicks(kJointTable[joint].start);  // safety goes there first, whoever drives
  const bool on_the_way = std::abs(now.commanded.value - now.position.value) > kAtRest && now.motion.age <= kBelieved;
  return on_the_way ? now.position : now.commanded;
}

}  // namespace darwinop::remote
