// Scripted byte line for unit tests: expected writes and their replies at simulated times.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"
#include "hil-mocks/script_failure.hpp"

namespace darwinop::hil {

///   ScriptedLine line;
///   line.expect(ping).answer(pong, 120us).expect(ping).silence().lose();
/// Steps are ordered. Failures: an unexpected write, a reply that is not read, and a step not reached at destruction.
/// The clock is simulated: reading advances to the reply or the deadline.
class ScriptedLine : public ByteLine {
 public:
  explicit ScriptedLine(ScriptFailure failure = abortOnScriptFailure) : failure_{std::move(failure)} {}
  ~ScriptedLine() override;
  ScriptedLine(const ScriptedLine&) = delete;
  ScriptedLine& operator=(const ScriptedLine&) = delete;

  /// The next write() must be exactly these bytes.
  ScriptedLine& expect(Bytes bytes);
  /// One read() returns these bytes, this long after the last write (or after the previous reply).
  ScriptedLine& answer(Bytes bytes, Nanos after = Nanos{0});
  /// One read() times out.
  ScriptedLine& silence();
  /// The next write() or read() returns kLost; the line works again after it.
  ScriptedLine& lose();

  [[nodiscard]] Nanos now() noexcept override { return now_; }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override;
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override;
  /// Also discards replies that are due.
  void discardInput() noexcept override;
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return reconnects_; }
  void advanceTo(Nanos when) noexcept { now_ = std::max(now_, when); }

  [[nodiscard]] bool finished() const { return steps_.empty(); }

 private:
  enum class Kind : std::uint8_t { kExpect, kAnswer, kSilence, kLose };
  struct Step {
    Kind kind;
    std::vector<std::uint8_t> bytes;
    Nanos after;
  };

  [[nodiscard]] bool takeLoss() noexcept;
  ScriptedLine& add(Kind kind, Bytes bytes, Nanos after);

  ScriptFailure failure_;
  std::deque<Step> steps_;
  Nanos now_{0}, since_{0};
  std::uint32_t reconnects_ = 0;
};

}  // namespace darwinop::hil
