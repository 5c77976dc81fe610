// Lines of an INI text for inih, tolerant of the syntax that robots' files have used since 2013.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// inih accepts only " ;" as a comment after a value and reads an indented line as a continuation; the parser that
/// controllers' files were written for accepted `16.0;text` and `16 # text`, and ignored indentation.
class IniLines {
 public:
  explicit IniLines(std::string_view text);

  /// As fgets: the next line without indentation and comments, cut to `size`; null at the end. For ini_parse_stream.
  char* next(char* into, int size);

  /// Number of the last line returned, from 1.
  [[nodiscard]] int number() const { return number_; }
  /// Number of the last line that was cut; 0: none.
  [[nodiscard]] int cut() const { return cut_; }

 private:
  std::string_view rest_;
  int number_ = 0, cut_ = 0;
};

/// `line` up to the first ; or #, without white space at its ends.
std::string_view withoutComment(std::string_view line);

/// `value` without the double quotes around it.
std::string_view withoutQuotes(std::string_view value);

}  // namespace darwinop::text
