// Finds the virtual robot that a symbolic link leads to.
#pragma once

#include <string>

namespace darwinop::hil {

/// After the link, before the id of its owner.
inline constexpr const char* kLinkTaken = " belongs to the virtual robot of process ";

/// Id of the running darwinop-virtual-robot whose pseudo terminal the link `path` names. Empty: none, so the link is
/// stale, or it is not visible here, as the processes of another user.
std::string linkOwner(const std::string& path);

}  // namespace darwinop::hil
