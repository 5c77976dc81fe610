// What follows when the default controller ends: nothing, another try, or none any more. Pure: time is an argument.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "hal/byte_line.hpp"

namespace darwinop::supervisor {

/// How a process ended.
struct Ending {
  int code = 0;  // exit code, or the number of the signal
  bool by_signal = false;

  [[nodiscard]] bool tidy() const { return !by_signal && code == 0; }
};

/// "with exit code 3", "by signal 11 (Segmentation fault)".
std::string describe(const Ending& ending);

class RestartPolicy {
 public:
  enum class Verdict {
    kOver,     // it has done its work
    kAgain,    // after kPause
    kGivenUp,  // a third crash within kWindow
  };
  // A controller that crashes at once is not started fifty times a second, and who stands by can step in.
  static constexpr Nanos kPause{2'000'000'000};
  static constexpr Nanos kWindow{60'000'000'000};
  static constexpr std::size_t kCrashes = 3;

  [[nodiscard]] Verdict ended(const Ending& ending, Nanos now);
  /// Another chance: earlier crashes no longer count.
  void forget() { count_ = 0; }
  /// Crashes that count at this time.
  [[nodiscard]] std::size_t crashes(Nanos now) const;

 private:
  std::array<Nanos, kCrashes> at_{};  // times of the last crashes, oldest first; the first `count_` are valid
  std::size_t count_ = 0;
};

}  // namespace darwinop::supervisor
