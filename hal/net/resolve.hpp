// A computer's name to addresses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace darwinop::net {

/// IPv4 addresses of a name or of four numbers with points, host byte order; at least one. Asks the system's resolver,
/// which may take seconds. Throws std::runtime_error.
[[nodiscard]] std::vector<std::uint32_t> addressesOf(const std::string& host);

}  // namespace darwinop::net
