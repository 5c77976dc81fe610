// Replaces a file at once: readers, a full disk and a power cut leave the old content or the new one.
#pragma once

#include <string>
#include <string_view>

namespace darwinop {

inline constexpr const char* kCannotWrite = "cannot write ";  // then the path

/// Writes a new file beside `path`, complete on the disk, with the mode and owner of `path` if that exists, else as the
/// umask says. Returns its name, for rename(). Throws std::runtime_error: "cannot write PATH: reason".
std::string writeBeside(const std::string& path, std::string_view text);

/// Makes a rename() in the folder of `path` survive a power cut.
void flushFolder(const std::string& path);

/// `path`, or what it points to if it is a symbolic link.
std::string linkedFile(const std::string& path);

}  // namespace darwinop
