// Parser of INI texts on top of inih: no line is ignored; the first error is thrown with file and line.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// Callbacks for the lines of a file. A std::runtime_error thrown by one ends the reading; file and line are put before
/// its message. Sections and keys keep their case.
class IniReader {
 public:
  virtual ~IniReader() = default;
  virtual void section(std::string_view /*name*/, int /*line*/) {}
  virtual void pair(std::string_view section, std::string_view key, std::string_view value, int line) = 0;
  /// A line that is neither a section nor key = value nor a comment.
  virtual void stray(std::string_view section, std::string_view text, int line) = 0;
};

/// "robot.ini, line 3"
std::string where(const std::string& file, int line);

/// `sentence` without "config.ini, " at its start: settings name the default file, readers prepend the real path.
std::string_view withoutFile(std::string_view sentence);

/// Throws std::runtime_error, "FILE, line N: what is wrong".
void readIni(std::string_view text, const std::string& file, IniReader& reader);

}  // namespace darwinop::text
