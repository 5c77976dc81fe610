// Progress of `darwinop gap`: one line that is overwritten on a terminal, else one line per step.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace darwinop::gap {

class ProgressLine {
 public:
  /// `quiet`: prints nothing.
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// To stderr. "2 of 3: dry friction explains a part of it" fills a third of the bar.
  void show(const std::string& what);
  /// Clears the line, so that results may be printed.
  void end();

 private:
  void draw();

  bool quiet_, terminal_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;  // of what follows
  std::condition_variable ended_;
  std::string what_;
  bool done_ = false;
  std::thread clock_;  // on a terminal: the seconds go on while a step takes long
};

}  // namespace darwinop::gap
