// Parses "tcp://USER@HOST", a robot reached through ssh.
#pragma once

#include <optional>
#include <string>

namespace darwinop::ssh {

/// USER@HOST of "tcp://USER@HOST"; nullopt: not an ssh target. Throws std::runtime_error if it contains a port.
std::optional<std::string> sshTarget(const std::string& robot);

}  // namespace darwinop::ssh
