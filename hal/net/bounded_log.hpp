// Lines for people, never more than some a minute: a client must not be able to fill a robot's disk.
#pragma once

#include <functional>
#include <string>

#include "hal/byte_line.hpp"

namespace darwinop::net {

class BoundedLog {
 public:
  using Say = std::function<void(const std::string&)>;
  static constexpr int kLinesPerMinute = 30;

  explicit BoundedLog(Say say) : say_{std::move(say)} {}

  void line(const std::string& text, Nanos now) {
    look(now);
    if (++lines_ <= kLinesPerMinute)
      say_(text);
    else
      ++left_out_;
  }
  /// When a minute is over, tells what it left out.
  void look(Nanos now) {
    if (now - minute_ < std::chrono::minutes{1}) return;
    if (left_out_ > 0) say_(std::to_string(left_out_) + " more lines in that minute were left out");
    minute_ = now;
    lines_ = left_out_ = 0;
  }

 private:
  Say say_;
  Nanos minute_{0};
  int lines_ = 0, left_out_ = 0;
};

}  // namespace darwinop::net
