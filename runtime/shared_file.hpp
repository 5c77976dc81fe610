// Opens files safely in a world-writable folder such as /dev/shm.
#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <optional>
#include <string>

#include "hal/descriptor.hpp"

namespace darwinop::runtime {

/// Accepted owners. A world-writable file, a symbolic link, a FIFO or a file with several hard links is never accepted.
enum class FileOwner {
  kOwn,    // this user or root
  kGroup,  // also a user who shares the file with a group of this process; root accepts root's only
  kAny,    // root also accepts files of every user: it may observe and release any robot
};

/// Does not follow links, block on a FIFO, or create the file. Nothing if there is no such file or this process may not
/// open it (see errno). Throws std::runtime_error with owner and remedy for a file that is not accepted.
std::optional<Descriptor> openShared(const std::string& path, int flags, FileOwner owner);

/// Removes whatever has this name; a folder with content gets another name. False: not permitted.
[[nodiscard]] bool removeAny(const std::string& path);

/// "user 'eve' (uid 1001)".
std::string ownerOf(const struct stat& status);

}  // namespace darwinop::runtime
