// Parses "tcp://USER@HOST".
#include "hal/net/ssh/target.hpp"

#include <stdexcept>
#include <string_view>

namespace darwinop::ssh {

std::optional<std::string> sshTarget(const std::string& robot) {
  constexpr std::string_view kTcp = "tcp://";
  if (!robot.starts_with(kTcp) || robot.find('@') == std::string::npos) return std::nullopt;
  std::string target = robot.substr(kTcp.size());
  const std::size_t host = target.rfind('@') + 1;
  if (target.find(':', host) != std::string::npos && target[host] != '[')
    throw std::runtime_error(
        "'" + robot + "' has a port; remove it: with USER@ the server's port is chosen automatically, and --ssh-port " +
        "sets the port of ssh");
  if (target[host] == '[' && target.ends_with(']')) {  // IPv6: ssh expects it without brackets
    target.pop_back();
    target.erase(host, 1);
  }
  return target;
}

}  // namespace darwinop::ssh
