// Progress output: an updated line on a terminal, otherwise one line per phase.
#pragma once

#include <string>

namespace darwinop::experiments {

class Progress {
 public:
  explicit Progress(double total_s);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Writes to stderr.
  void update(const std::string& phase, double seconds);

 private:
  double total_s_;
  bool terminal_;
  std::string phase_;
  int quarter_ = -1;  // of a second, last printed
};

}  // namespace darwinop::experiments
