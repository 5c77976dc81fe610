// Active faults: present causes plus latched faults, and the strongest reaction among them.
#pragma once

#include <array>
#include <bit>
#include <bitset>
#include <cstdint>

#include "core/faults.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

using FaultSet = std::bitset<kFaults>;  // by row of kFaultTable

/// Row of a fault in kFaultTable.
constexpr std::size_t rowIndex(Fault fault) {
  constexpr auto kRows = [] {
    std::array<std::uint8_t, 256> rows{};
    for (std::size_t i = 0; i < kFaults; ++i)
      rows[static_cast<std::size_t>(kFaultTable[i].fault)] = static_cast<std::uint8_t>(i);
    return rows;
  }();
  return kRows[static_cast<std::size_t>(fault)];
}

/// `fault` alone, or nothing.
constexpr FaultSet faultIf(bool active, Fault fault) {
  return FaultSet{static_cast<unsigned long long>(active) << rowIndex(fault)};
}

/// Calls f(row) for each of `faults`, in the order of the table.
template <class F>
constexpr void forEachFault(const FaultSet& faults, F&& f) {
  for (unsigned long rest = faults.to_ulong(); rest != 0; rest &= rest - 1)
    f(static_cast<std::size_t>(std::countr_zero(rest)));
}

/// All faults for whose row `is(row)` is true.
template <class Is>
constexpr FaultSet faultsThat(Is is) {
  unsigned long long bits = 0;
  for (std::size_t i = 0; i < kFaults; ++i) bits |= static_cast<unsigned long long>(is(kFaultTable[i])) << i;
  return FaultSet{bits};
}
inline constexpr FaultSet kLatchedFaults = faultsThat([](const FaultRow& fault) { return fault.latched; });
inline constexpr FaultSet kLatchedLimpFaults =
    faultsThat([](const FaultRow& fault) { return fault.latched && fault.reaction == Reaction::kLimp; });

/// The first active latched fault; kNone: there is none.
[[nodiscard]] inline Fault latchedFault(const FaultSet& active) {
  const unsigned long latched = (active & kLatchedFaults).to_ulong();
  return latched == 0 ? Fault::kNone : kFaultTable[static_cast<std::size_t>(std::countr_zero(latched))].fault;
}

/// A latched fault keeps torque off: the robot was released, or lost its power.
[[nodiscard]] inline bool keptLimp(const FaultSet& active) {
  return (active & kLatchedLimpFaults).any();
}

/// Causes of faults in one cycle.
struct FaultCauses {
  FaultSet all;
  std::array<std::uint8_t, kFaults> servo{};  // id of the first servo that each concerns, 0 for none

  void note(Fault fault, bool cause) noexcept { all |= faultIf(cause, fault); }
  void note(const FaultSet& causes, std::uint8_t id) noexcept {
    forEachFault(causes & ~all, [&](std::size_t row) { servo[row] = id; });
    all |= causes;
  }
};

class FaultBook {
 public:
  explicit FaultBook(const Config& config) : config_{config} {}

  /// Once a cycle.
  void update(const FaultCauses& causes) noexcept;
  /// Clears all faults. Those whose cause persists become active again in the same cycle.
  void reset() noexcept;

  [[nodiscard]] const FaultSet& all() const noexcept { return active_; }
  /// The active fault with the strongest reaction, the first of equals; kNone: no fault is active.
  [[nodiscard]] Fault worst() const noexcept;
  [[nodiscard]] std::uint8_t servo(Fault fault) const noexcept;
  [[nodiscard]] Reaction reaction(Fault fault) const noexcept;
  [[nodiscard]] bool endsController() const noexcept;
  /// An active fault requires the gentle speed, independent of stronger reactions.
  [[nodiscard]] bool slow() const noexcept;

 private:
  const Config& config_;
  FaultSet active_;
  std::array<std::uint8_t, kFaults> servo_{};
};

}  // namespace darwinop::safety
