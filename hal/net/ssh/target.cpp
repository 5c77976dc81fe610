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
    throw std::runtime_error("'" + robot +
                             "' has a port: with a user in front the server gets one by itself; the port of ssh " +
                             "is said with --ssh-port");
  if (target[host] == '[' && target.ends_with(']')) {  // IPv6, which ssh knows without brackets
    target.pop_back();
    target.erase(host, 1);
  }
  return target;
}

}  // namespace darwinop::ssh
