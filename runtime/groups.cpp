// Names of groups and users, read from /etc.
#include "runtime/groups.hpp"

#include <grp.h>
#include <pwd.h>

#include <cstdio>
#include <memory>

namespace darwinop::runtime {
namespace {

/// `found(entry)` of the first entry for which `wanted(entry)` is true.
template <typename Result, typename Wanted, typename Found>
std::optional<Result> lookUp(const std::string& path, Wanted wanted, Found found) {
  const std::unique_ptr<FILE, int (*)(FILE*)> file{std::fopen(path.c_str(), "re"), std::fclose};
  if (!file) return std::nullopt;
  while (const group* entry = fgetgrent(file.get()))
    if (wanted(*entry)) return found(*entry);
  return std::nullopt;
}

}  // namespace

std::optional<gid_t> groupId(const std::string& name, const std::string& file) {
  return lookUp<gid_t>(
      file, [&](const group& entry) { return name == entry.gr_name; }, [](const group& entry) { return entry.gr_gid; });
}

std::string groupName(gid_t id, const std::string& file) {
  return lookUp<std::string>(
             file, [&](const group& entry) { return id == entry.gr_gid; },
             [](const group& entry) { return std::string{entry.gr_name}; })
      .value_or(std::to_string(id));
}

std::optional<std::string> userName(uid_t id, const std::string& path) {
  const std::unique_ptr<FILE, int (*)(FILE*)> file{std::fopen(path.c_str(), "re"), std::fclose};
  if (!file) return std::nullopt;
  while (const passwd* entry = fgetpwent(file.get()))
    if (entry->pw_uid == id) return std::string{entry->pw_name};
  return std::nullopt;
}

}  // namespace darwinop::runtime
