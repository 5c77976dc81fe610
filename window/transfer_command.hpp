// The command line of darwinop-install for what a page asks, and what a page asks for what stands on a command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "window/transfer_words.hpp"

namespace darwinop::window {

/// Its words after the program, never the password. Paths become absolute, so that none can be taken for an option.
/// Throws std::runtime_error when there is no such folder or key.
[[nodiscard]] std::vector<std::string> installerWords(const TransferStart& start);

/// As one would type it: "darwinop install --status darwin@192.168.123.1".
[[nodiscard]] std::string typedCommand(const std::vector<std::string>& words);

/// The robot that a program logs in to: USER@HOST, port and key file as they were given, empty: not. Nothing: no page
/// could name it so.
[[nodiscard]] std::optional<RobotAddress> robotOf(const std::string& target, const std::string& port,
                                                  const std::string& key);

/// Folders with controllers beside the installer, as in the source tree; there need be none.
[[nodiscard]] std::vector<std::string> controllersBeside(const std::string& installer);

}  // namespace darwinop::window
