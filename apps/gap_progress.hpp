// Progress output of `darwinop gap`: an updated line on a terminal, else one line per step.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace darwinop::gap {

class ProgressLine {
 public:
  /// `quiet`: no output.
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Prints to stderr. "2 of 3: dry friction explains a part of it" fills a third of the bar.
  void show(const std::string& what);
  /// Clears the line, so that results may be printed.
  void end();

 private:
  void draw();

  bool quiet_, terminal_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;  // protects the members below
  std::condition_variable ended_;
  std::string what_;
  bool done_ = false;
  std::thread clock_;  // on a terminal: updates the elapsed time
};

}  // namespace darwinop::gap
