// Conversion between a page's transfer request and the command line of darwinop-install.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "window/transfer/transfer_message.hpp"

namespace darwinop::window {

/// Arguments after the program name, never the password. Paths become absolute, so that none is taken for an option.
/// Throws std::runtime_error if a folder or key does not exist.
[[nodiscard]] std::vector<std::string> installerArguments(const TransferStart& start);

/// As text in a shell: "darwinop install --status darwin@192.168.123.1".
[[nodiscard]] std::string typedCommand(const std::vector<std::string>& arguments);

/// The robot of an ssh login: USER@HOST, port and key file as given; empty: not given. Nullopt: not valid for a page.
[[nodiscard]] std::optional<RobotAddress> robotOf(const std::string& target, const std::string& port,
                                                  const std::string& key);

/// Controller folders beside the installer, as in the source tree; may be empty.
[[nodiscard]] std::vector<std::string> controllersBeside(const std::string& installer);

}  // namespace darwinop::window
