// Rate-limited log: a client must not be able to fill a robot's disk with log lines.
#pragma once

#include <functional>
#include <string>

#include "hal/byte_line.hpp"

namespace darwinop::net {

class BoundedLog {
 public:
  using Log = std::function<void(const std::string&)>;
  static constexpr int kLinesPerMinute = 30;

  explicit BoundedLog(Log log) : log_{std::move(log)} {}

  void line(const std::string& text, Nanos now) {
    reportOmitted(now);
    if (++lines_ <= kLinesPerMinute)
      log_(text);
    else
      ++omitted_;
  }
  /// Logs the number of omitted lines when a minute is over.
  void reportOmitted(Nanos now) {
    if (now - minute_ < std::chrono::minutes{1}) return;
    if (omitted_ > 0) log_(std::to_string(omitted_) + " more lines in that minute were left out");
    minute_ = now;
    lines_ = omitted_ = 0;
  }

 private:
  Log log_;
  Nanos minute_{0};
  int lines_ = 0, omitted_ = 0;
};

}  // namespace darwinop::net
