// A line of a fault script, with a cursor over its words.
#pragma once

#include <string>
#include <string_view>

#include "hal/byte_line.hpp"

namespace darwinop::hil {

/// Refers to the text and the file's name. Errors are std::runtime_error with file, line and word.
class ScriptLine {
 public:
  /// Without the comment, from '#' on.
  ScriptLine(std::string_view text, std::string_view file, std::size_t number);

  /// The next word; empty at the end of the line.
  std::string_view next();
  /// Throws: the last word is wrong; `allowed` says what is right.
  [[noreturn]] void fail(const std::string& allowed) const;
  /// The next word as a number.
  double number(std::string_view what, double low, double high);
  /// The next word as a time in seconds.
  Nanos time(std::string_view what, double low_s);

  /// Calls `take` for each part of the next word, "a+b+c".
  template <class F>
  void parts(F&& take) {
    std::string_view word = next();
    while (true) {
      const std::size_t plus = word.find('+');
      take(word.substr(0, plus));
      if (plus == word.npos) return;
      word.remove_prefix(plus + 1);
    }
  }

 private:
  std::string_view rest_, word_, file_;
  std::size_t number_;
};

}  // namespace darwinop::hil
