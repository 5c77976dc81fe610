#include "connect/keys.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "hal/held_keys.hpp"
#include "hal/keyboard_terminal/key_terminal.hpp"
#include "hal/keyboard_x11/key_window.hpp"

namespace darwinop::connect {
namespace {

/// Data of the thread. Outlives the KeySource if the X server does not respond.
class KeyWork {
 public:
  KeyWork(KeysRequest request, const std::atomic<bool>& ending)
      : request_{std::move(request)}, ending_{ending}, stop_fd_{::eventfd(0, EFD_CLOEXEC)} {
    if (stop_fd_ < 0) throw std::system_error{errno, std::generic_category(), "keys need an eventfd"};
  }
  ~KeyWork() { ::close(stop_fd_); }
  KeyWork(const KeyWork&) = delete;
  KeyWork& operator=(const KeyWork&) = delete;

  void run() noexcept {
    try {
      lookAndListen();
    } catch (...) {  // no memory for a message: no keys
    }
    const std::lock_guard lock{mutex_};
    ended_ = true;
    changed_.notify_all();
  }

  /// False: the thread does not end and must be abandoned; it logs nothing any more.
  bool stop() {
    const std::uint64_t one = 1;
    static_cast<void>(!::write(stop_fd_, &one, sizeof one));
    constexpr std::chrono::milliseconds kGrace{200};
    std::unique_lock lock{mutex_};
    request_.log = nullptr;
    stopping_ = true;
    return changed_.wait_for(lock, kGrace, [this] { return ended_; });
  }

  HeldKeys keys;

 private:
  void lookAndListen() {
    if (request_.from == "none") return;
    std::string why = "no window is wanted";
    if (request_.from != "terminal" && fromWindow(why)) return;
    if (request_.from == "window") return log(kNoKeys + (": " + why));
    if (!fromTerminal(why))
      log(kNoKeys + (": no window (" + why + "); start the controller in a terminal, or in a graphical session"));
  }

  /// False and the reason: there is no window.
  bool fromWindow(std::string& why) {
    try {
      const std::string no_more = ": no key is pressed from now on; Ctrl-C ends the controller";
      x11::KeyWindow window{keys, request_.display};
      switch (window.run(stop_fd_)) {
        case x11::KeyWindow::End::kStopped:
          break;
        case x11::KeyWindow::End::kClosed:
          log(kKeyWindowClosed + no_more);
          break;
        case x11::KeyWindow::End::kServerGone:
          log(kKeyServerGone + no_more);
      }
      return true;
    } catch (const std::exception& error) {
      why = error.what();
      return false;
    }
  }

  bool fromTerminal(std::string& why) {
    {
      const std::lock_guard lock{mutex_};
      if (stopping_) return true;  // the terminal must not be changed while the program ends
    }
    try {
      terminal::KeyTerminal terminal{keys};
      log("no window (" + why + "): " + kKeysFromTerminal + "; Ctrl-C ends the controller");
      if (terminal.run(stop_fd_, ending_) == terminal::KeyTerminal::End::kTerminalGone)
        log("the terminal is gone: no key is pressed from now on");
      return true;
    } catch (const std::exception& error) {
      why += std::string{"), no terminal ("} + error.what();
      return false;
    }
  }

  void log(const std::string& sentence) {
    const std::lock_guard lock{mutex_};
    if (request_.log) request_.log(sentence);
  }

  KeysRequest request_;
  const std::atomic<bool>& ending_;
  int stop_fd_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false, ended_ = false;
};

class Keys final : public KeySource {
 public:
  Keys(KeysRequest request, const std::atomic<bool>& ending)
      : work_{std::make_shared<KeyWork>(std::move(request), ending)} {
    sigset_t all, before;
    ::sigfillset(&all);
    // Signals of the thread's own errors stay unblocked.
    for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigdelset(&all, own);
    ::pthread_sigmask(SIG_BLOCK, &all, &before);  // inherited by the new thread: signals are for the main one
    try {
      thread_ = std::thread{[work = work_] {
        const sched_param none{};
        ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &none);  // the creating thread may be real-time
        ::pthread_setname_np(::pthread_self(), "darwinop-keys");
        work->run();
      }};
    } catch (...) {
      ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
      throw;
    }
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  ~Keys() override {
    if (work_->stop())
      thread_.join();
    else
      thread_.detach();
  }
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  std::vector<Key> take() override { return work_->keys.take(); }

 private:
  std::shared_ptr<KeyWork> work_;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<KeySource> openKeys(KeysRequest request, const std::atomic<bool>& ending) {
  if (!request.from.empty() && request.from != "window" && request.from != "terminal" && request.from != "none")
    throw std::runtime_error("DARWINOP_KEYS=" + request.from + ": it is window, terminal or none");
  return std::make_unique<Keys>(std::move(request), ending);
}

}  // namespace darwinop::connect
