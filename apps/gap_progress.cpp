#include "gap_progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace darwinop::gap {
namespace {

constexpr int kBar = 24, kWidth = 96;  // columns

/// Of "2 of 3: …": a third is done.
std::string barFor(const std::string& what) {
  int step = 0, of = 0;
  if (std::sscanf(what.c_str(), "%d of %d:", &step, &of) != 2 || of < 1) return "";
  const int full = std::clamp(kBar * (step - 1) / of, 0, kBar);
  return "[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(kBar - full), '-') + "] ";
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) : quiet_{quiet}, terminal_{isatty(STDERR_FILENO) == 1} {
  if (quiet_ || !terminal_) return;
  clock_ = std::thread{[this] {
    std::unique_lock lock{mutex_};
    while (!ended_.wait_for(lock, std::chrono::milliseconds{250}, [this] { return done_; })) draw();
  }};
}

ProgressLine::~ProgressLine() {
  end();
}

void ProgressLine::show(const std::string& what) {
  if (quiet_) return;
  const std::lock_guard lock{mutex_};
  what_ = what;
  if (terminal_)
    draw();
  else
    std::fprintf(stderr, "darwinop gap: %s\n", what.c_str());
}

void ProgressLine::end() {
  if (!clock_.joinable()) return;
  {
    const std::lock_guard lock{mutex_};
    done_ = true;
  }
  ended_.notify_all();
  clock_.join();
  std::fputs("\r\033[K", stderr);
}

void ProgressLine::draw() {
  if (what_.empty()) return;
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  std::string line = barFor(what_) + what_;
  if (line.size() > kWidth - 8) line.resize(kWidth - 8);
  std::fprintf(stderr, "\r%s, %.0f s\033[K", line.c_str(), elapsed_s);
}

}  // namespace darwinop::gap
