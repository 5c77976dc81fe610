// Applies faults from a script, from calls, or at random to a virtual board and its line.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "hil-mocks/chunk.hpp"
#include "hil-mocks/fault.hpp"
#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {

/// Deterministic for a given seed. Not thread-safe.
class FaultInjector {
 public:
  explicit FaultInjector(std::uint64_t seed = 1);

  /// A fault with a past start time starts at the next apply().
  void add(const InjectedFault& fault);
  void add(std::span<const InjectedFault> faults);
  /// Ends every fault, including scheduled ones.
  void clear() noexcept;

  /// Time of the next change by apply().
  [[nodiscard]] Nanos nextChange() const noexcept { return next_change_; }
  void apply(Nanos now, VirtualBoard& board) noexcept;
  /// Applies active wire faults to a frame.
  void pass(Chunk& chunk, Way way) noexcept;
  [[nodiscard]] bool portOpen() const noexcept { return !unplugged_; }

  [[nodiscard]] std::uint64_t seed() const noexcept { return seed_; }
  /// Number of faults started so far.
  [[nodiscard]] std::uint64_t begun() const noexcept { return begun_; }
  [[nodiscard]] std::uint64_t begun(FaultKind kind) const noexcept { return begun_of_[static_cast<std::size_t>(kind)]; }
  /// Number of active faults.
  [[nodiscard]] std::size_t active() const noexcept { return active_.size(); }

 private:
  struct Active {
    InjectedFault fault;
    Nanos next_draw{0};  // random, babble
  };

  static constexpr std::size_t kRoom = 256;  // concurrent faults; no more are drawn

  void begin(const InjectedFault& fault, VirtualBoard& board) noexcept;
  void babble(Active& source, Nanos now, VirtualBoard& board) noexcept;
  void draw(Active& source, Nanos now) noexcept;
  void showEffects(Nanos now, VirtualBoard& board) noexcept;
  void planNext(Nanos now) noexcept;

  std::uint64_t seed_;
  Rng random_;
  std::vector<InjectedFault> waiting_;  // sorted, latest first
  std::vector<Active> active_;
  std::uint64_t begun_ = 0;
  std::array<std::uint64_t, kFaultKinds> begun_of_{};
  Nanos next_change_ = Nanos::max();
  std::bitset<kJoints> dead_;
  bool cleared_ = false;
  bool unplugged_ = false, wire_faults_ = false;
};

}  // namespace darwinop::hil
