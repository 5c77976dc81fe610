#include "runtime/driver_session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/joints.hpp"

namespace darwinop::runtime {
namespace {

constexpr std::atomic<bool> kNever{false};
constexpr double kAtRest = 0.1;               // rad: maximum distance of a joint at rest from its goal, under any load
constexpr std::uint32_t kMaxPositionAge = 3;  // cycles: an older position may be far off

/// Position at which to hold a joint; unknown if it has no goal.
Rad holdPosition(const JointSensors& now) {
  const bool on_the_way =
      std::abs(now.commanded.value - now.position.value) > kAtRest && now.motion.age <= kMaxPositionAge;
  return on_the_way ? now.position : now.commanded;
}

}  // namespace

std::string describe(const SafetyReport& report) {
  const FaultRow& fault = row(report.worst);
  std::string text{fault.meaning};
  if (report.worst_joint >= 1 && report.worst_joint <= kJoints)
    text += " (" + std::string{kJointTable[report.worst_joint - 1U].name} + ", id " +
            std::to_string(report.worst_joint) + ")";
  return text + "; " + std::string{fault.remedy};
}

void DriverSession::start() {
  if (started_) link_->beginSession();
  started_ = true;
  published_ = false;
  first_cycle_ = link_->sensors().cycle + 2;
}

/// Cycles may have passed since start(), with the fault of a session that was given up still active.
void DriverSession::publish(const Commands& commands) {
  link_->publish(commands);
  if (!std::exchange(published_, true)) first_cycle_ = std::max(first_cycle_, link_->sensors().cycle + 2);
}

bool DriverSession::drives(const Sensors& seen) const {
  return seen.cycle >= first_cycle_ && seen.safety.state == State::kDriven;
}

bool DriverSession::waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) {
  return link_->waitForCycle(cycle, stop);
}

bool DriverSession::waitForCycle(std::uint64_t cycle) {
  return link_->waitForCycle(cycle, kNever);
}

std::string DriverSession::faultEnd(const Sensors& seen) const {
  return seen.cycle >= first_cycle_ && seen.safety.controller_must_end ? describe(seen.safety) : std::string{};
}

std::string DriverSession::loopEnd(const Sensors& seen) {
  return waitForCycle(seen.cycle) ? std::string{} : link_->whyEnded();  // a finished cycle, so this does not block
}

/// Safety holds a silent driver only after stall_ms, and lets a slow joint continue to its goal; this holds at once.
void DriverSession::hold(Commands& commands) {
  if (!published_) return;  // without commands no session has begun
  const Sensors seen = sensors();
  for (std::size_t i = 0; i < kJoints; ++i)
    if (const Rad rest = holdPosition(seen.joint[i]); rest.known()) commands.joint[i].setGoal(rest);
  Commands last = commands;
  last.hold = true;
  publish(last);
  link_->leaveHolding();
}

void DriverSession::end(Commands last) {
  last.end_of_session = true;
  publish(last);
}

}  // namespace darwinop::runtime
