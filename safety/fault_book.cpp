// Active faults.
#include "safety/fault_book.hpp"

namespace darwinop::safety {

void FaultBook::update(const FaultCauses& causes) noexcept {
  // A latched fault keeps the id of the servo that caused it.
  const FaultSet kept = active_ & kLatchedFaults;
  forEachFault(causes.all & ~kept, [&](std::size_t row) { servo_[row] = causes.servo[row]; });
  active_ = causes.all | kept;
}

void FaultBook::reset() noexcept {
  active_.reset();
}

Fault FaultBook::worst() const noexcept {
  Fault worst = Fault::kNone;
  forEachFault(active_, [&](std::size_t row) {
    const Fault fault = kFaultTable[row].fault;
    if (worst == Fault::kNone || reaction(fault) > reaction(worst)) worst = fault;
  });
  return worst;
}

std::uint8_t FaultBook::servo(Fault fault) const noexcept {
  return fault == Fault::kNone ? std::uint8_t{0} : servo_[rowIndex(fault)];
}

Reaction FaultBook::reaction(Fault fault) const noexcept {
  if (fault == Fault::kNone) return Reaction::kReport;
  if (fault == Fault::kFell && config_.on_fall == OnFall::kLimp) return Reaction::kLimp;
  return kFaultTable[rowIndex(fault)].reaction;
}

bool FaultBook::slow() const noexcept {
  static constexpr FaultSet kSlow = faultsThat([](const FaultRow& fault) { return fault.reaction == Reaction::kSlow; });
  return (active_ & kSlow).any();
}

bool FaultBook::endsController() const noexcept {
  static constexpr FaultSet kEnding = faultsThat([](const FaultRow& fault) { return fault.ends_controller; });
  return (active_ & kEnding).any();
}

}  // namespace darwinop::safety
