// Restart policy of the default controller: done, restart, or give up. Pure: time is an argument.
#pragma once

#include <array>
#include <cstddef>

#include "hal/byte_line.hpp"
#include "hal/process/ending.hpp"

namespace darwinop::supervisor {

class RestartPolicy {
 public:
  enum class Verdict {
    kOver,     // finished normally
    kAgain,    // after kPause
    kGivenUp,  // a third crash within kWindow
  };
  // Prevents a restart loop of fifty per second, and gives bystanders time to act.
  static constexpr Nanos kPause{2'000'000'000};
  static constexpr Nanos kWindow{60'000'000'000};
  static constexpr std::size_t kCrashes = 3;

  [[nodiscard]] Verdict ended(const process::Ending& ending, Nanos now);
  /// Forgets earlier crashes.
  void forget() { count_ = 0; }
  /// Crashes within the window at this time.
  [[nodiscard]] std::size_t crashes(Nanos now) const;

 private:
  std::array<Nanos, kCrashes> at_{};  // times of the last crashes, oldest first; the first `count_` are valid
  std::size_t count_ = 0;
};

}  // namespace darwinop::supervisor
