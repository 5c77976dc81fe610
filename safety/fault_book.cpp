// Which faults are active.
#include "safety/fault_book.hpp"

namespace darwinop::safety {

void FaultBook::note(Fault fault, bool cause, std::uint8_t servo) noexcept {
  const std::size_t i = rowIndex(fault);
  const bool keeps = active_[i] && kFaultTable[i].latched;
  // A latched fault goes on naming the servo that raised it.
  if (cause && !keeps) servo_[i] = servo;
  active_[i] = cause || keeps;
}

void FaultBook::reset() noexcept {
  active_.reset();
}

Fault FaultBook::worst() const noexcept {
  Fault worst = Fault::kNone;
  for (std::size_t i = 0; i < kFaults; ++i) {
    const Fault fault = kFaultTable[i].fault;
    if (active_[i] && (worst == Fault::kNone || reaction(fault) > reaction(worst))) worst = fault;
  }
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
  for (std::size_t i = 0; i < kFaults; ++i)
    if (active_[i] && kFaultTable[i].reaction == Reaction::kSlow) return true;
  return false;
}

bool FaultBook::endsController() const noexcept {
  for (std::size_t i = 0; i < kFaults; ++i)
    if (active_[i] && kFaultTable[i].ends_controller) return true;
  return false;
}

}  // namespace darwinop::safety
