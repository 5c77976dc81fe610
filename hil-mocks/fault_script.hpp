// Fault script parser; one fault per line. Format: docs/virtual-robot.md.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "hil-mocks/fault.hpp"

namespace darwinop::hil {

inline constexpr std::size_t kMostFaults = 100'000;
inline constexpr std::size_t kLongestFaultScript = 16 << 20;  // bytes

/// Throws std::runtime_error "FILE:LINE: field 'WORD': expected ...". No side effects.
[[nodiscard]] std::vector<InjectedFault> parseFaultScript(std::string_view text, std::string_view file_name);

}  // namespace darwinop::hil
