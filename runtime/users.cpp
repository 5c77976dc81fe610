// Users, read from /etc/passwd and /etc/group; change of user.
#include "runtime/users.hpp"

#include <grp.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace darwinop::runtime {
namespace {

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

File openFile(const std::string& path) {
  return {std::fopen(path.c_str(), "re"), std::fclose};
}

std::vector<gid_t> groupsOf(const std::string& user, gid_t first, const std::string& path) {
  std::vector<gid_t> groups{first};
  const File file = openFile(path);
  if (!file) return groups;
  while (const group* entry = fgetgrent(file.get()))
    for (char** member = entry->gr_mem; *member != nullptr; ++member)
      if (user == *member && std::ranges::find(groups, entry->gr_gid) == groups.end()) groups.push_back(entry->gr_gid);
  return groups;
}

}  // namespace

std::optional<process::Account> findAccount(const std::string& name, const UserFiles& files) {
  const File file = openFile(files.passwd);
  if (!file) return std::nullopt;
  while (const passwd* entry = fgetpwent(file.get()))
    if (name == entry->pw_name)
      return process::Account{name, entry->pw_dir, entry->pw_uid, entry->pw_gid,
                              groupsOf(name, entry->pw_gid, files.group)};
  return std::nullopt;
}

void becomeUser(const process::Account& account) {
  if (!takeRightsOf(account))
    throw std::runtime_error("cannot become user " + account.name + ": " + std::strerror(errno));
  for (const auto& [name, value] : environmentOf(account)) setenv(name.c_str(), value.c_str(), 1);
}

}  // namespace darwinop::runtime
