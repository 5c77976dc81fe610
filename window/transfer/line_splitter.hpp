// Splits a program's output into lines.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace darwinop::window {

/// Truncates lines longer than kLongest bytes and appends "…".
class LineSplitter {
 public:
  static constexpr std::size_t kLongest = 2000;
  using OnLine = std::function<void(std::string_view line)>;

  void add(std::string_view bytes, const OnLine& on_line);
  /// End of output: emits an unterminated last line.
  void end(const OnLine& on_line);

 private:
  void finish(const OnLine& on_line);

  std::string line_;
  bool cut_ = false;
};

}  // namespace darwinop::window
