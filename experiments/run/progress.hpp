// Where an experiment is, told while it runs: one line that is written over on a terminal, else one line a phase.
#pragma once

#include <string>

namespace darwinop::experiments {

class Progress {
 public:
  explicit Progress(double total_s);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// To stderr.
  void tell(const std::string& phase, double seconds);

 private:
  double total_s_;
  bool terminal_;
  std::string phase_;
  int quarter_ = -1;  // of a second, told last
};

}  // namespace darwinop::experiments
