// Users, read from /etc/passwd and /etc/group: getpwnam() and initgroups() ask plug-ins of the C library, which a
// static program has not.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace darwinop::runtime {

struct UserFiles {
  std::string passwd = "/etc/passwd", group = "/etc/group";
};

struct Account {
  std::string name, home;
  uid_t uid;
  gid_t gid;
  std::vector<gid_t> groups;  // all of them, the one above first
};

/// Empty when there is no user of this name.
std::optional<Account> findAccount(const std::string& name, const UserFiles& files = {});

/// What a program of that user finds in its environment.
std::vector<std::pair<std::string, std::string>> environmentOf(const Account& account);

/// Only async-signal-safe calls, so that a child may do it between fork and exec. False: errno says why, and the
/// process has to end.
bool takeRightsOf(const Account& account) noexcept;

/// For good, with the environment. Throws std::runtime_error.
void becomeUser(const Account& account);

}  // namespace darwinop::runtime
