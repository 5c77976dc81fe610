// Reads the text of an INI file: every line is somebody's, and the first error is told with file and line.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// What one kind of file does with its lines. A std::runtime_error thrown here ends the reading; file and line are
/// put before its sentence. Sections and keys come as they were written.
class IniReader {
 public:
  virtual ~IniReader() = default;
  virtual void section(std::string_view /*name*/, int /*line*/) {}
  virtual void pair(std::string_view section, std::string_view key, std::string_view value, int line) = 0;
  /// A line that is no section, no key = value and no comment.
  virtual void stray(std::string_view section, std::string_view text, int line) = 0;
};

/// "robot.ini, line 3"
std::string where(const std::string& file, int line);

/// `sentence` without "config.ini, " at its start: settings name the usual file, readers put the real path before it.
std::string_view withoutFile(std::string_view sentence);

/// Throws std::runtime_error, "FILE, line N: what is wrong".
void readIni(std::string_view text, const std::string& file, IniReader& reader);

}  // namespace darwinop::text
