// Names of groups and users, read from /etc: getgrnam() and getpwnam() need plug-ins of the C library, which static
// programs cannot load.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace darwinop::runtime {

std::optional<gid_t> groupId(const std::string& name, const std::string& file = "/etc/group");

/// The group's name; its number as text if it has none.
std::string groupName(gid_t id, const std::string& file = "/etc/group");

/// Nothing if the user is not in the file.
std::optional<std::string> userName(uid_t id, const std::string& file = "/etc/passwd");

}  // namespace darwinop::runtime
