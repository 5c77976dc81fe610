// The command line of darwinop-install for what a page asks.
#pragma once

#include <string>
#include <vector>

#include "window/transfer_words.hpp"

namespace darwinop::window {

/// Its words after the program, never the password. Paths become absolute, so that none can be taken for an option.
/// Throws std::runtime_error when there is no such folder or key.
[[nodiscard]] std::vector<std::string> installerWords(const TransferStart& start);

/// As one would type it: "darwinop install --status darwin@192.168.123.1".
[[nodiscard]] std::string typedCommand(const std::vector<std::string>& words);

/// Folders with controllers beside the installer, as in the source tree; there need be none.
[[nodiscard]] std::vector<std::string> controllersBeside(const std::string& installer);

}  // namespace darwinop::window
