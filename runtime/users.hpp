// Users, read from /etc/passwd and /etc/group: getpwnam() and initgroups() need plug-ins of the C library, which static
// programs cannot load.
#pragma once

#include <optional>
#include <string>

#include "hal/process/account.hpp"

namespace darwinop::runtime {

struct UserFiles {
  std::string passwd = "/etc/passwd", group = "/etc/group";
};

/// Empty if there is no user of this name.
std::optional<process::Account> findAccount(const std::string& name, const UserFiles& files = {});

/// Switches user, groups and environment permanently. Throws std::runtime_error.
void becomeUser(const process::Account& account);

}  // namespace darwinop::runtime
