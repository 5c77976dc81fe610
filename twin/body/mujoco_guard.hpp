// Recovers from MuJoCo errors with longjmp: its error handler must not return, and the default one waits for Enter and
// exits.
#pragma once

#include <csetjmp>
#include <stdexcept>
#include <string>
#include <utility>

namespace darwinop::twin {

/// While it exists, MuJoCo errors of its thread return to attempt(). At most one per thread.
class MujocoGuard {
 public:
  MujocoGuard() noexcept;
  ~MujocoGuard();
  MujocoGuard(const MujocoGuard&) = delete;
  MujocoGuard& operator=(const MujocoGuard&) = delete;

  /// Runs `action`; false after a MuJoCo error, with its text in why(); the objects that MuJoCo worked on are then
  /// invalid. No object with a destructor may exist inside `action` while MuJoCo runs. Allocates nothing.
  template <class Action>
  [[nodiscard]] bool attempt(Action&& action) noexcept {
    if (setjmp(back_) != 0) return false;
    std::forward<Action>(action)();
    return true;
  }
  [[nodiscard]] const char* why() const noexcept { return why_; }

 private:
  static void onError(const char* why);
  std::jmp_buf back_;
  char why_[200] = "";
};

/// Replaces each run of blanks and line breaks by one space.
std::string oneLine(const std::string& text);

inline constexpr const char* kMujocoError = "MuJoCo error with this body: ";

/// Runs `action`; throws std::runtime_error, prefixed with `who`, after a MuJoCo error.
template <class Action>
void orThrow(const std::string& who, Action&& action) {
  MujocoGuard guard;
  if (!guard.attempt(std::forward<Action>(action)))
    throw std::runtime_error{who + ": " + kMujocoError + oneLine(guard.why())};
}

}  // namespace darwinop::twin
