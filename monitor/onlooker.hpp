// Looks for a runtime's shared memory, and notices when its runtime comes, ends, dies or hangs.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "runtime/exchange.hpp"
#include "runtime/names.hpp"

namespace darwinop::monitor {

/// Never drives: takes no lease and writes nothing.
class Onlooker {
 public:
  static constexpr Nanos kLook{200'000'000}, kHung{5'000'000'000};

  explicit Onlooker(runtime::RuntimeFiles files) : files_{std::move(files)} {}

  /// Five times a second at most it really looks. True: there is one now and was none, or the other way round, or the
  /// reason is another.
  bool look(Nanos now);

  /// Nothing while there is no runtime whose loop turns.
  [[nodiscard]] const runtime::ExchangeBlock* block() const;
  /// Why there is none: a sentence with what to do.
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// Pid of the one that drives, 0: nobody, -1: of another user.
  [[nodiscard]] pid_t driver() const;

 private:
  [[nodiscard]] std::string whyNone(Nanos now);

  runtime::RuntimeFiles files_;
  std::optional<runtime::Exchange> exchange_;
  std::string reason_ = "not looked yet";
  Nanos next_look_{0}, moved_{0};
  std::uint32_t finished_ = 0;
};

}  // namespace darwinop::monitor
