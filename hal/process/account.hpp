// User account that a process runs as.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace darwinop::process {

struct Account {
  std::string name, home;
  uid_t uid;
  gid_t gid;
  std::vector<gid_t> groups;  // all of them, the one above first
};

/// HOME, USER and LOGNAME of a program of that user.
std::vector<std::pair<std::string, std::string>> environmentOf(const Account& account);

/// Async-signal-safe, so that a child can call it between fork and exec. False: errno has the reason, and the process
/// must end.
bool takeRightsOf(const Account& account) noexcept;

}  // namespace darwinop::process
