// Which faults are active. Takes causes as they are now, keeps what latches, knows the strongest reaction.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "core/faults.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

/// Row of a fault in kFaultTable.
constexpr std::size_t rowIndex(Fault fault) {
  for (std::size_t i = 0; i < kFaults; ++i)
    if (kFaultTable[i].fault == fault) return i;
  return 0;
}

/// The first active fault that stays until a person resets it; kNone: there is none.
[[nodiscard]] constexpr Fault latchedFault(const std::bitset<kFaults>& active) {
  for (std::size_t i = 0; i < kFaults; ++i)
    if (active[i] && kFaultTable[i].latched) return kFaultTable[i].fault;
  return Fault::kNone;
}

/// A latched fault keeps torque off: the robot was released, or lost its power.
[[nodiscard]] constexpr bool keptLimp(const std::bitset<kFaults>& active) {
  for (std::size_t i = 0; i < kFaults; ++i)
    if (active[i] && kFaultTable[i].latched && kFaultTable[i].reaction == Reaction::kLimp) return true;
  return false;
}

class FaultBook {
 public:
  explicit FaultBook(const Config& config) : config_{config} {}

  /// The cause of `fault` as it is in this cycle; `servo`: id it concerns, 0 for none.
  void note(Fault fault, bool cause, std::uint8_t servo = 0) noexcept;
  /// Forgets all. Those whose cause is still there are noted again in the same cycle.
  void reset() noexcept;

  [[nodiscard]] bool active(Fault fault) const noexcept { return active_[rowIndex(fault)]; }
  [[nodiscard]] const std::bitset<kFaults>& all() const noexcept { return active_; }
  /// Strongest reaction among the active ones, first of equals; kNone when all is well.
  [[nodiscard]] Fault worst() const noexcept;
  [[nodiscard]] std::uint8_t servo(Fault fault) const noexcept;
  [[nodiscard]] Reaction reaction(Fault fault) const noexcept;
  [[nodiscard]] bool endsController() const noexcept;
  /// A fault asks for gentle speed, whatever stronger ones ask for besides.
  [[nodiscard]] bool slow() const noexcept;

 private:
  const Config& config_;
  std::bitset<kFaults> active_;
  std::array<std::uint8_t, kFaults> servo_{};
};

}  // namespace darwinop::safety
