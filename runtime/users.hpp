// Users, read from /etc/passwd and /etc/group: getpwnam() and initgroups() ask plug-ins of the C library, which a
// static program has not.
#pragma once

#include <optional>
#include <string>

#include "hal/process/account.hpp"

namespace darwinop::runtime {

struct UserFiles {
  std::string passwd = "/etc/passwd", group = "/etc/group";
};

/// Empty when there is no user of this name.
std::optional<process::Account> findAccount(const std::string& name, const UserFiles& files = {});

/// For good, with the environment. Throws std::runtime_error.
void becomeUser(const process::Account& account);

}  // namespace darwinop::runtime
