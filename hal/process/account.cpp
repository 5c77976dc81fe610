#include "hal/process/account.hpp"

#include <grp.h>
#include <unistd.h>

namespace darwinop::process {

std::vector<std::pair<std::string, std::string>> environmentOf(const Account& account) {
  return {{"HOME", account.home}, {"USER", account.name}, {"LOGNAME", account.name}};
}

bool takeRightsOf(const Account& account) noexcept {
  // In this order: without root's rights the groups could not be changed any more. setgid() and setuid() of root set
  // the saved ids as well, so there is no way back.
  return setgroups(account.groups.size(), account.groups.data()) == 0 && setgid(account.gid) == 0 &&
         setuid(account.uid) == 0;
}

}  // namespace darwinop::process
