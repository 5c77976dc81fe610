// Faults written down as text, one a line. The format is described in docs/virtual-robot.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hil-mocks/fault.hpp"

namespace darwinop::hil {

/// Throws std::runtime_error "FILE:LINE: field 'WORD': what is allowed". Touches nothing but its arguments.
[[nodiscard]] std::vector<Fault> parseFaultScript(std::string_view text, std::string_view file_name);
/// Reads the file; throws std::runtime_error also when it cannot be read.
[[nodiscard]] std::vector<Fault> loadFaultScript(const std::string& path);

}  // namespace darwinop::hil
