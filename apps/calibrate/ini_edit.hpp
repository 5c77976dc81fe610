// Changes keys in the text of an INI file and replaces the file without ever losing the old one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace darwinop::calibrate {

struct IniValue {
  std::string key, value, comment;
};

/// `text` with these keys in `section`: existing lines are replaced in place, others follow the last line of the
/// section, a missing section is added at the end. All other bytes stay.
std::string withValues(std::string_view text, std::string_view section, const std::vector<IniValue>& values);

/// Writes `text` to `path`. The old file stays as PATH.before-STAMP (with -2, -3, ... if that exists), with its
/// content, owner and mode. A power cut leaves the old or the new file, complete. Returns the name of the old file;
/// empty: there was none. Throws std::runtime_error; the file is then unchanged.
std::string replaceKeepingOld(const std::string& path, std::string_view text, const std::string& stamp);

}  // namespace darwinop::calibrate
