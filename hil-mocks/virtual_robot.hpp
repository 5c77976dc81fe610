// Board, body and faults together: what stands at the far end of a line.
#pragma once

#include <memory>
#include <optional>

#include "hil-mocks/fault_injector.hpp"
#include "hil-mocks/plain_body.hpp"
#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {

/// Time only moves forward. Not thread-safe. Allocates nothing after construction unless faults are added.
class VirtualRobot {
 public:
  /// Without a body it gets a PlainBody.
  explicit VirtualRobot(const BoardOptions& options = {}, std::uint64_t seed = 1, std::unique_ptr<Body> body = nullptr);

  void receive(Bytes bytes, Nanos when) noexcept;
  void advance(Nanos until) noexcept { advance(until, false); }
  /// As advance(), but returns as soon as output() has something.
  void advanceToReply(Nanos until) noexcept { advance(until, true); }
  [[nodiscard]] Nanos now() const noexcept { return now_; }
  /// Until then advance() brings nothing to see, unless something is received; nothing: for ever.
  [[nodiscard]] std::optional<Nanos> nextWake() const noexcept;

  /// What the PC sees, after faults, in the order of `at`.
  [[nodiscard]] ChunkRing& output() noexcept { return output_; }
  /// False while the cable is out: bytes both ways are lost.
  [[nodiscard]] bool portOpen() const noexcept { return faults_.portOpen(); }
  /// How often the cable came back.
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
