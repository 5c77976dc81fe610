// Names of groups, read from /etc/group: getgrnam() asks plug-ins of the C library, which a static program has not.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace darwinop::runtime {

std::optional<gid_t> groupId(const std::string& name, const std::string& file = "/etc/group");

/// The name, or the number as text when the group has none.
std::string groupName(gid_t id, const std::string& file = "/etc/group");

}  // namespace darwinop::runtime
