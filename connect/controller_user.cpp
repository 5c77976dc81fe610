// User account of controllers.
#include "connect/controller_user.hpp"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "runtime/daemon_link.hpp"
#include "runtime/groups.hpp"
#include "runtime/names.hpp"

namespace darwinop::connect {
namespace {

constexpr const char* kRoot = "root";
constexpr auto kNoGroup = static_cast<gid_t>(-1);

gid_t existingGroup(const std::string& name, const runtime::UserFiles& files) {
  if (const std::optional<gid_t> found = runtime::groupId(name, files.group)) return *found;
  throw std::runtime_error("there is no group '" + name + "'; make it with: sudo groupadd " + name);
}

}  // namespace

gid_t runtimeGroup(const RobotFile& robot, const std::optional<std::string>& asked, const runtime::UserFiles& files) {
  const std::string name = asked.value_or(robot.group);
  if (!name.empty()) return existingGroup(name, files);
  return asked ? kNoGroup : runtime::groupId(kControllerUser, files.group).value_or(kNoGroup);
}

std::optional<process::Account> controllerAccount(const RobotFile& robot, const runtime::UserFiles& files) {
  if (robot.controller_user == kRoot) return std::nullopt;
  const bool named = !robot.controller_user.empty();
  const std::string name = named ? robot.controller_user : kControllerUser;
  std::optional<process::Account> account = runtime::findAccount(name, files);
  if (!account && named)
    throw std::runtime_error(robot.path + ": there is no user '" + name +
                             "' for [Robot] controller_user; make it, or leave the line out");
  // The user need not be a member of the runtime's group in robot.ini.
  const gid_t group = runtimeGroup(robot, std::nullopt, files);
  if (account && group != kNoGroup && std::ranges::find(account->groups, group) == account->groups.end())
    account->groups.push_back(group);
  return account;
}

std::optional<process::Account> defaultControllerAccount(const RobotFile& robot, const runtime::UserFiles& files) {
  std::optional<process::Account> account = controllerAccount(robot, files);
  if (!account && robot.controller_user != kRoot)
    throw std::runtime_error(std::string{"there is no user "} + kControllerUser +
                             " to run it as, and it is not run as root. 'darwinop install' makes the user; "
                             "[Robot] controller_user = root in robot.ini runs it as root all the same");
  return account;
}

void leaveRoot() {
  if (geteuid() != 0) return;
  if (const auto account = controllerAccount(readRobotFile())) runtime::becomeUser(*account);
}

bool usesRuntime(const std::string& setting) {
  return setting == "runtime" || (setting.empty() && runtime::daemonPid(runtime::RuntimeFiles{}) != 0);
}

}  // namespace darwinop::connect
