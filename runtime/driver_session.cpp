#include "runtime/driver_session.hpp"

#include "core/joints.hpp"
#include "runtime/exchange_link.hpp"

namespace darwinop::runtime {
namespace {

constexpr std::atomic<bool> kNever{false};

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
  if (auto* const exchange = dynamic_cast<ExchangeLink*>(link_.get()); started_ && exchange != nullptr)
    exchange->beginSession();
  started_ = true;
  first_cycle_ = link_->sensors().cycle + 2;
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

void DriverSession::hold(const Commands& last) {
  publish(last);
  link_->leaveHolding();
}

void DriverSession::end(Commands last) {
  last.end_of_session = true;
  publish(last);
}

}  // namespace darwinop::runtime
