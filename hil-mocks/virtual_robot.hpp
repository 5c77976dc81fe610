// Virtual robot: board, body and faults at the far end of a line.
#pragma once

#include <memory>
#include <optional>

#include "hil-mocks/fault_injector.hpp"
#include "hil-mocks/plain_body.hpp"
#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {

/// Time only advances. Not thread-safe. Allocates nothing after construction unless faults are added.
class VirtualRobot {
 public:
  /// Uses a PlainBody by default.
  explicit VirtualRobot(const BoardOptions& options = {}, std::uint64_t seed = 1, std::unique_ptr<Body> body = nullptr);

  void receive(Bytes bytes, Nanos when) noexcept;
  void advance(Nanos until) noexcept { advance(until, false); }
  /// As advance(), but returns as soon as output() has data.
  void advanceToReply(Nanos until) noexcept { advance(until, true); }
  [[nodiscard]] Nanos now() const noexcept { return now_; }
  /// No output before this time unless something is received; empty: never.
  [[nodiscard]] std::optional<Nanos> nextWake() const noexcept;

  /// Data for the PC, after faults, ordered by `at`.
  [[nodiscard]] ChunkRing& output() noexcept { return output_; }
  /// False while unplugged: bytes in both directions are lost.
  [[nodiscard]] bool portOpen() const noexcept { return faults_.portOpen(); }
  /// Number of replugs.
  [[nodiscard]] std::uint32_t replugs() const noexcept { return replugs_; }

  [[nodiscard]] VirtualBoard& board() noexcept { return board_; }
  [[nodiscard]] const VirtualBoard& board() const noexcept { return board_; }
  [[nodiscard]] FaultInjector& faults() noexcept { return faults_; }
  [[nodiscard]] Body& body() noexcept { return *body_; }

 private:
  void advance(Nanos until, bool stop_at_reply) noexcept;
  void collectReplies() noexcept;
  void applyFaults() noexcept;

  std::unique_ptr<Body> body_;
  VirtualBoard board_;
  FaultInjector faults_;
  ChunkRing output_{1024};
  Nanos now_{0}, last_at_{0};
  std::uint32_t replugs_ = 0;
};

}  // namespace darwinop::hil
