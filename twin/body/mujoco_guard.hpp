// MuJoCo gives up by calling a handler that must not return; its own asks the terminal to press Enter, and exits.
#pragma once

#include <csetjmp>
#include <stdexcept>
#include <string>
#include <utility>

namespace darwinop::twin {

/// While it lives on a thread, that thread's MuJoCo errors jump back to attempt(). One at a time per thread.
class MujocoGuard {
 public:
  MujocoGuard() noexcept;
  ~MujocoGuard();
  MujocoGuard(const MujocoGuard&) = delete;
  MujocoGuard& operator=(const MujocoGuard&) = delete;

  /// Runs `action`. False: MuJoCo gave up in the middle, and why() says the reason; what it worked on is not to be used
  /// again. Nothing with a destructor may live in `action` while MuJoCo runs. No heap.
  template <class Action>
  [[nodiscard]] bool attempt(Action&& action) noexcept {
    if (setjmp(back_) != 0) return false;
    std::forward<Action>(action)();
    return true;
  }
  [[nodiscard]] const char* why() const noexcept { return why_; }

 private:
  static void giveUp(const char* why);
  std::jmp_buf back_;
  char why_[200] = "";
};

/// In one line, without what programs put between words.
std::string oneLine(const std::string& text);

/// Runs `action`; throws std::runtime_error that begins with `who` when MuJoCo gives up in it.
template <class Action>
void orThrow(const std::string& who, Action&& action) {
  MujocoGuard guard;
  if (!guard.attempt(std::forward<Action>(action)))
    throw std::runtime_error{who + ": MuJoCo gives up on this body: " + oneLine(guard.why())};
}

}  // namespace darwinop::twin
