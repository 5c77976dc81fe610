#include "hal/keyboard_terminal/key_terminal.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>

#include "hal/keyboard_terminal/key_report.hpp"

namespace darwinop::terminal {
namespace {

constexpr int kLookMs = 50;

Nanos monotonic() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace

KeyTerminal::End KeyTerminal::run(int stop_fd, const std::atomic<bool>& ending) {
  std::array<pollfd, 2> files{{{stop_fd, POLLIN, 0}, {fd_, POLLIN, 0}}};
  End end = End::kStopped;
  raw_.askForReports();
  while (!ending) {
    const int ready = ::poll(files.data(), files.size(), kLookMs);
    if (ready > 0 && files[0].revents != 0) break;
    if (ready > 0 && files[1].revents != 0 && (!readAll() || (files[1].revents & POLLHUP) != 0)) {
      end = End::kTerminalGone;
      break;
    }
    const Nanos now = monotonic();
    if (const auto event = decoder_.timeOut(now)) handle(*event, now);
    typed_.expire(now);
    watchForSilence(now);
  }
  keys_.releaseAll();
  return end;
}

/// Returns false if the terminal is closed, or if this program is now in its background.
bool KeyTerminal::readAll() {
  std::array<char, 64> bytes{};
  const ssize_t count = ::read(fd_, bytes.data(), bytes.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  const Nanos now = monotonic();
  for (const KeyEvent& event : decoder_.feed({bytes.data(), static_cast<std::size_t>(count)}, now)) handle(event, now);
  return true;
}

void KeyTerminal::handle(const KeyEvent& event, Nanos now) {
  const bool pressed = event.kind == KeyEvent::Kind::kTyped || event.kind == KeyEvent::Kind::kPressed;
  if (const int signal = pressed ? RawMode::signalOf(event.key) : 0) {
    static_cast<void>(kill(0, signal));  // the foreground process group, as the terminal would
    return;
  }
  switch (event.kind) {
    case KeyEvent::Kind::kTyped:
      return typed_.type(event.key, now);
    case KeyEvent::Kind::kPressed:
      return keys_.press(event.id, event.key & kKeyCodeMask, event.key & ~kKeyCodeMask);
    case KeyEvent::Kind::kReleased:
      return keys_.release(event.id);
    case KeyEvent::Kind::kModifiers:
      return keys_.setModifiers(event.key);
    case KeyEvent::Kind::kFocusLost:
      return keys_.releaseAll();
    case KeyEvent::Kind::kReports:
      asked_at_.reset();
      has_reports_ = !raw_.startReports();  // the second reply has the flags of the started reports
  }
}

void KeyTerminal::watchForSilence(Nanos now) {
  if (!has_reports_ || keys_.down().empty()) return asked_at_.reset();
  if (!asked_at_) {
    if (now < next_question_) return;
    next_question_ = now + kQuestions;
    raw_.askForReports();
    asked_at_ = now;
  } else if (now - *asked_at_ > kSilence) {
    keys_.releaseAll();
  }
}

}  // namespace darwinop::terminal
