// Attaches to a runtime's shared memory and detects when the runtime starts, ends, dies or hangs.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "runtime/exchange.hpp"
#include "runtime/names.hpp"

namespace darwinop::monitor {

/// Read-only: takes no lease and writes nothing.
class RuntimeObserver {
 public:
  static constexpr Nanos kCheckInterval{200'000'000}, kHung{5'000'000'000};
  // After "the runtime (pid N)".
  static constexpr const char* kHangs =
      " is alive but has not run a cycle for 5 s; check it with: darwinop runtime --status";

  explicit RuntimeObserver(runtime::RuntimeFiles files) : files_{std::move(files)} {}

  /// Checks at most five times a second. True: the runtime has appeared or disappeared, or the reason has changed.
  bool update(Nanos now);

  /// Null while there is no runtime with a running loop.
  [[nodiscard]] const runtime::ExchangeBlock* block() const;
  /// Why block() is null, with the remedy.
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// Pid of the process with the driving lease; 0: none, -1: a process of another user.
  [[nodiscard]] pid_t driver() const;

 private:
  [[nodiscard]] std::string whyUnavailable(Nanos now);

  runtime::RuntimeFiles files_;
  std::optional<runtime::Exchange> exchange_;
  std::string reason_ = "not checked yet";
  Nanos next_check_{0}, advanced_at_{0};
  std::uint32_t finished_ = 0;
};

}  // namespace darwinop::monitor
