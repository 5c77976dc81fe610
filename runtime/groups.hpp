// Names of groups and users, read from /etc: getgrnam() and getpwnam() ask plug-ins of the C library, which a static
// program has not.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace darwinop::runtime {

std::optional<gid_t> groupId(const std::string& name, const std::string& file = "/etc/group");

/// The name, or the number as text when the group has none.
std::string groupName(gid_t id, const std::string& file = "/etc/group");

/// Nothing when the user has no name here.
std::optional<std::string> userName(uid_t id, const std::string& file = "/etc/passwd");

}  // namespace darwinop::runtime
