#include "hal/keyboard_terminal/raw_mode.hpp"

#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "hal/diagnostics.hpp"
#include "hal/keyboard_terminal/key_report.hpp"

namespace darwinop::terminal {
namespace {

// State for the signal handler; written before the handlers are installed.
termios before;
std::atomic<int> raw_fd{-1};
std::atomic<bool> reports_keys{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler reads them");

constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGQUIT};

/// tcsetattr(), tcflush(), poll() and write() are async-signal-safe. In the background they raise SIGTTOU, hence the
/// blocking.
void restore() {
  const int fd = raw_fd.exchange(-1);
  if (fd < 0) return;
  sigset_t own, kept;
  sigemptyset(&own);
  sigaddset(&own, SIGTTOU);
  pthread_sigmask(SIG_BLOCK, &own, &kept);
  if (reports_keys.exchange(false)) {
    (void)writeWithoutWaiting(fd, kEndReports);
    tcflush(fd, TCIFLUSH);  // reports that the shell would take for text
  }
  tcsetattr(fd, TCSANOW, &before);
  pthread_sigmask(SIG_SETMASK, &kept, nullptr);
}

/// SA_RESETHAND restored the default action; raising the signal again applies it.
void onCrash(int signal) {
  const int error = errno;
  restore();
  static_cast<void>(raise(signal));  // delivered when this handler returns, at the faulting instruction
  errno = error;
}

void watchForCrashes() {
  for (const int signal : kCrashes) {
    struct sigaction now {};
    // Handlers of sanitizers and of the program are kept.
    if (sigaction(signal, nullptr, &now) != 0 || (now.sa_flags & SA_SIGINFO) != 0 || now.sa_handler != SIG_DFL)
      continue;
    struct sigaction action {};
    action.sa_handler = onCrash;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
    sigaction(signal, &action, nullptr);
  }
}

void watchNoMore() {
  for (const int signal : kCrashes) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) != 0 || (now.sa_flags & SA_SIGINFO) != 0 || now.sa_handler != onCrash)
      continue;
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    sigaction(signal, &usual, nullptr);
  }
}

}  // namespace

RawMode::RawMode(int fd) : fd_{fd} {
  if (isatty(fd) == 0) throw std::runtime_error(kInputNotATerminal);
  if (tcgetpgrp(fd) != getpgrp()) throw std::runtime_error("this program runs in the background");
  if (raw_fd >= 0) throw std::runtime_error("this terminal is already used for keyboard input");
  if (tcgetattr(fd, &before) != 0)
    throw std::runtime_error(std::string{"cannot read terminal settings: "} + std::strerror(errno));
  termios raw = before;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | IEXTEN);
  raw.c_iflag &= ~static_cast<tcflag_t>(IXON | ICRNL);  // Ctrl-S must not stop the output
  raw.c_cc[VSUSP] = _POSIX_VDISABLE;
  raw.c_cc[VMIN] = 0;  // read() never blocks
  raw.c_cc[VTIME] = 0;
  watchForCrashes();
  [[maybe_unused]] static const int at_exit = std::atexit(restore);  // exit() does not destroy local objects
  raw_fd = fd;
  if (tcsetattr(fd, TCSANOW, &raw) != 0) {
    const int error = errno;
    raw_fd = -1;
    watchNoMore();
    throw std::runtime_error(std::string{"cannot change terminal settings: "} + std::strerror(error));
  }
}

RawMode::~RawMode() {
  restore();
  watchNoMore();
}

void RawMode::askForReports() noexcept {
  (void)writeWithoutWaiting(fd_, kAskForReports);
}

bool RawMode::startReports() {
  if (reports_keys.exchange(true)) return false;
  (void)writeWithoutWaiting(fd_, std::string{kStartReports} + std::string{kAskForReports});
  return true;
}

int RawMode::signalOf(Key key) noexcept {
  constexpr int kControlBits = 0x1F;  // of the byte that Control and a letter send
  if ((before.c_lflag & ISIG) == 0 || (key & ~kKeyCodeMask) != kKeyControl) return 0;
  const int code = key & kKeyCodeMask, byte = code & kControlBits;
  if (code <= '@' || code > '_') return 0;
  return byte == before.c_cc[VINTR] ? SIGINT : byte == before.c_cc[VQUIT] ? SIGQUIT : 0;
}

}  // namespace darwinop::terminal
