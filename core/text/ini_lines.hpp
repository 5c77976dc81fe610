// Hands the lines of an INI text to inih one by one, with the liberties that robots' files have taken since 2013.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// inih takes only " ;" for a comment after a value and reads an indented line as more of the value above; the
/// parser that controllers' files were written for took `16.0;text` and `16 # text`, and ignored indentation.
class IniLines {
 public:
  explicit IniLines(std::string_view text);

  /// As fgets: the next line without indentation and comments, cut to `size`; null at the end. For ini_parse_stream.
  char* next(char* into, int size);

  /// Of the line handed out last, from 1.
  [[nodiscard]] int number() const { return number_; }
  /// Number of the last line that had to be cut, 0: none.
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
