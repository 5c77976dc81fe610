// "tcp://USER@HOST": a robot that a program of this PC logs in to.
#pragma once

#include <optional>
#include <string>

namespace darwinop::ssh {

/// USER@HOST of "tcp://USER@HOST"; nothing: another robot is meant. Throws std::runtime_error for one with a port.
std::optional<std::string> sshTarget(const std::string& robot);

}  // namespace darwinop::ssh
