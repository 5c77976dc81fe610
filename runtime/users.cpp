// Users, read from /etc/passwd and /etc/group, and becoming one of them.
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

std::optional<Account> findAccount(const std::string& name, const UserFiles& files) {
  const File file = openFile(files.passwd);
  if (!file) return std::nullopt;
  while (const passwd* entry = fgetpwent(file.get()))
    if (name == entry->pw_name)
      return Account{name, entry->pw_dir, entry->pw_uid, entry->pw_gid, groupsOf(name, entry->pw_gid, files.group)};
  return std::nullopt;
}

std::vector<std::pair<std::string, std::string>> environmentOf(const Account& account) {
  return {{"HOME", account.home}, {"USER", account.name}, {"LOGNAME", account.name}};
}

bool takeRightsOf(const Account& account) noexcept {
  // In this order: without root's rights the groups could not be changed any more. setgid() and setuid() of root set
  // the saved ids also, so there is no way back.
  return setgroups(account.groups.size(), account.groups.data()) == 0 && setgid(account.gid) == 0 &&
         setuid(account.uid) == 0;
}

void becomeUser(const Account& account) {
  if (!takeRightsOf(account))
    throw std::runtime_error("cannot become user " + account.name + ": " + std::strerror(errno));
  for (const auto& [name, value] : environmentOf(account)) setenv(name.c_str(), value.c_str(), 1);
}

}  // namespace darwinop::runtime
